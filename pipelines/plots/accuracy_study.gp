# Error of a study's results against its run time, for plain Monte Carlo with several sizes of cells and steps.
# usage: gnuplot -c accuracy_study.gp PICTURE TABLE      writes PICTURE.png and PICTURE.svg from pipelines/accuracy's study.tsv
picture = ARG1
table = ARG2
set datafile separator tab

# A curve for each cell, step, anti-locking and design, from few realizations to many.
sizes = "100 400 1000"
choices = system("awk -F '\t' 'NR > 1 && !seen[$1 FS $2 FS $3 FS $4]++ { print $1 \"/\" $2 \"/\" $3 \"/\" $4 }' '".table."'")
part(choice, k) = system(sprintf("echo '%s' | cut -d / -f %d", choice, k))
unless(usual, found) = found eq usual ? "" : ", ".found
label(choice) = part(choice, 1)." m, step ".part(choice, 2).unless("none", part(choice, 3)).unless("plain", part(choice, 4))
array colour[7] = ["#d95f02", "#a6761d", "#08306b", "#7570b3", "#1b9e77", "#e7298a", "#666666"]
array mark[7] = [9, 13, 7, 11, 5, 6, 8]
# Time and error, a line for each size.
program = "NR == 1 { for (i = 1; i <= NF; ++i) place[$i] = i; n = split(sizes, size, \" \") } ".\
  "$1 \"/\" $2 \"/\" $3 \"/\" $4 == choice && $5 == quantity && $6 == statistic ".\
  "{ for (i = 1; i <= n; ++i) print size[i] * $place[\"time_of_a_run_s\"] FS $place[\"error_\" size[i] \"_percent\"] }"
rows_of(choice, quantity, statistic) = sprintf("< awk -F '\t' -v choice='%s' -v quantity=%s -v statistic='%s' -v sizes='%s' '%s' '%s'", \
  choice, quantity, statistic, sizes, program, table)
# Boundaries want a sample that sets them.
is_known(quantity, statistic) = int(system(sprintf("awk -F '\t' '$5 == \"%s\" && $6 == \"%s\" && $11 != \"nan\"' '%s' | wc -l", \
  quantity, statistic, table))) > 0

set border 3
set tics out nomirror
set logscale xy
set grid lc "#dddddd" lw 1 lt 1
set key samplen 3 vertical maxrows 3 center top at screen 0.5, screen 0.985
set xrange [5:40000]
set yrange [0.1:50]

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,1000 font "sans,14" } else { set terminal svg noenhanced size 1500,1000 font "sans,14" }
  set output picture.".".format
  set key
  set multiplot layout 2,3 margins 0.07,0.97,0.09,0.86 spacing 0.05,0.14
  do for [quantity in "influence_m runout_m"] {
    do for [statistic in "mean sd 1_%_boundary"] {
      statistic = statistic eq "1_%_boundary" ? "1 % boundary" : statistic
      set title (quantity eq "influence_m" ? "I: " : "R: ").statistic
      set xlabel quantity eq "runout_m" ? "time of the study (s)" : ""
      set ylabel statistic eq "mean" ? "error (%)" : ""
      if (!is_known(quantity, statistic)) { set multiplot next; unset key; continue }
      plot for [i = 1:words(choices)] rows_of(word(choices, i), quantity, statistic) using 1:2 \
        with linespoints lw 2 lc rgb colour[i] pt mark[i] ps 1.2 title label(word(choices, i))
      unset key
    }
  }
  unset multiplot
  set output
}
