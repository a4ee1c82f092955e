# Error of one realization against its run time, for series of choices, all against the finest run.
# usage: gnuplot -c accuracy_realization.gp PICTURE TABLE      writes PICTURE.png and PICTURE.svg from pipelines/accuracy's realization.tsv
picture = ARG1
table = ARG2
set datafile separator tab

# The first reference of the table; errors below `floor` per cent are drawn there.
against = system("awk -F '\t' 'NR == 2 { print $1 \"\t\" $2 }' '".table."'")
floor = 0.1
series = "cell cell_single cell_B-bar cell_1_point points step order shapes rest"
array name[9] = ["cells, 2 x 2 points", "cells, single precision", "cells, B-bar", "cells, 1 point", "points in cells of 0.2 m", "step", "update order", "shape functions", "rest rule"]
array colour[9] = ["#08306b", "#3fa7d6", "#1b9e77", "#d95f02", "#7570b3", "#a6761d", "#e7298a", "#666666", "#000000"]
array mark[9] = [7, 12, 5, 9, 11, 13, 6, 8, 4]
rows_of(i) = sprintf("< grep '^%s\t%s\t' '%s'", against, word(series, i), table)
columns = "influence_error_percent runout_error_percent surface_error_percent energy_error_percent"
array title[4] = ["Influence distance I: error (%)", "Runout distance R: error (%)", "Final surface: area between, of the slope's (%)", "Energy balance: error (%)"]
field(name) = int(system(sprintf("awk -F '\t' 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == \"%s\") print i }' '%s'", name, table)))
time = field("time_s")
is_there(i) = int(system(sprintf("grep -c '^%s\t%s\t' '%s' || true", against, word(series, i), table))) > 0

set border 3
set tics out nomirror
set logscale xy
set grid lc "#dddddd" lw 1 lt 1
set yrange [0.7 * floor:70]
set key samplen 3 vertical maxrows 3 center top at screen 0.5, screen 0.985

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,1000 font "sans,14" } else { set terminal svg noenhanced size 1500,1000 font "sans,14" }
  set output picture.".".format
  set key
  set multiplot layout 2,2 margins 0.06,0.97,0.09,0.86 spacing 0.06,0.14
  do for [panel = 1:4] {
    value = field(word(columns, panel))
    set title title[panel]
    set xlabel panel > 2 ? "run time (s)" : ""
    plot for [i = 1:9] (is_there(i) ? rows_of(i) : "< echo nan") \
      using (column(time)):(abs(column(value)) > floor ? abs(column(value)) : column(value) == 0 && i == 1 ? NaN : floor) \
      with linespoints lw 2 lc rgb colour[i] pt mark[i] ps 1.3 title name[i]
    unset key
  }
  unset multiplot
  set output
}
