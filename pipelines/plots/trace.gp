# Running mean and standard deviation of the reach with 95 % bands, run by run (the source paper's Fig. 11).
# usage: gnuplot -c trace.gp PICTURE TRACE      writes PICTURE.png and PICTURE.svg from mcstats --trace
picture = ARG1
trace = ARG2
set datafile separator tab
set datafile commentschars "#"

of(quantity, value) = strcol("quantity") eq quantity ? value : NaN
runs = int(system("awk '$1 == \"runout_m\"' '".trace."' | wc -l"))

set border 3
set xtics out nomirror
set ytics out nomirror
set grid ytics lc "#bbbbbb" lw 1 lt 1
set key top right samplen 2
set style fill solid 1 noborder
set xrange [0:runs > 1 ? runs : 2]
if (runs < 2) { set yrange [0:1] }

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,900 font "sans,14" } else { set terminal svg noenhanced size 1500,900 font "sans,14" }
  set output picture.".".format
  set multiplot layout 2,2 margins 0.07,0.97,0.08,0.94 spacing 0.07,0.12
  do for [statistic in "mean sd"] {
    do for [panel in "influence_m runout_m"] {
      set title (statistic eq "mean" ? "Mean of the " : "Standard deviation of the ").(panel eq "influence_m" ? "influence distance I" : "runout distance R")
      set xlabel statistic eq "sd" ? "realizations" : ""
      set ylabel panel eq "influence_m" ? "m" : ""
      # The first runs scatter beyond all measure: the axis is scaled to what comes after a tenth of them.
      since = runs > 40 ? runs / 10 : runs > 4 ? 4 : 0  # fewer than 5 bound no sd
      if (runs < 2) { plot NaN notitle; continue }
      plot trace using (column("n") > since ? column("n") : NaN):(of(panel, column(statistic."_low_m"))):(of(panel, column(statistic."_high_m"))) \
             with filledcurves lc "#c6dbef" title "95 % band", \
           trace using (column("n") > since ? column("n") : NaN):(of(panel, column(statistic."_m"))) with lines lc "#08306b" lw 3 title "so far"
    }
  }
  unset multiplot
  set output
}
