# Correlations of samples of random fields at lags along both axes, with their intervals, against theory.
# usage: gnuplot -c field_check.gp PICTURE FOLDER      writes PICTURE.png and PICTURE.svg from FOLDER/panels.tsv (name, title, ...) and
#        FOLDER/NAME.tsv, written by rfgen --check
picture = ARG1
folder = ARG2
set datafile separator tab
set datafile commentschars "#"
stats folder."/panels.tsv" using 3 nooutput
panels = STATS_records

set border 3
set xtics out nomirror
set ytics out nomirror
set yrange [-0.3:1]
set xrange [0:*]
set key top right Right samplen 2

field(row, column) = system(sprintf("sed -n %dp '%s/panels.tsv' | cut -f %d", row, folder, column))
is_lag(along, across, value) = strcol("quantity") eq "correlation" && strcol("field") eq "cohesion" && column(along) > 0 && column(across) == 0 ? value : NaN

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,1400 font "sans,12" } else { set terminal svg noenhanced size 1500,1400 font "sans,12" }
  set output picture.".".format
  rows = (panels + 3) / 4
  set multiplot layout rows, 4 margins 0.035, 0.99, 0.05, 0.965 spacing 0.04, 0.06
  do for [panel = 1:panels] {
    table = folder."/".field(panel, 1).".tsv"
    set title field(panel, 2) offset 0,-0.7
    set xlabel (panel > panels - 4 ? "lag (m)" : "")
    if (panel > 1) { unset key }
    plot table using "lag_x_m":(is_lag("lag_x_m", "lag_y_m", column("theory"))) with lines lc "#d95f02" lw 1.5 title "theory along x", \
         table using "lag_y_m":(is_lag("lag_y_m", "lag_x_m", column("theory"))) with lines lc "#1b6ca8" lw 1.5 title "along y", \
         table using "lag_x_m":(is_lag("lag_x_m", "lag_y_m", column("estimate"))):"ci_low":"ci_high" with yerrorbars lc "#d95f02" pt 7 ps 0.5 title "samples", \
         table using "lag_y_m":(is_lag("lag_y_m", "lag_x_m", column("estimate"))):"ci_low":"ci_high" with yerrorbars lc "#1b6ca8" pt 7 ps 0.5 title "samples"
  }
  unset multiplot
  set key top right Right samplen 2
  set output
}
