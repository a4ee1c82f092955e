# How the errors of verification cases fall with the size of cell, step or increment, and the number at which a cut collapses.
# usage: gnuplot -c convergence.gp PICTURE OUT      writes PICTURE.png and PICTURE.svg from the cases' tables OUT/*.tsv
picture = ARG1
out = ARG2
set datafile separator tab

curves = "softening_point:stress_xy_pa free_fall:fall_m gravity_column:rms_stress_error_part elastic_bar:period_s rigid_rotation:energy_kept"
titles = "'softening, strain increment' 'free fall, step' 'column, stress' 'bar, period' 'rotation, energy'"
file(curve) = sprintf("%s/%s.tsv", out, curve[1:strstrt(curve, ":") - 1])
rows_of(curve) = sprintf("< grep '\t%s\t' %s", curve[strstrt(curve, ":") + 1:*], file(curve))
colour(i) = word("#4575b4 #1a9850 #d73027 #6a3d9a #fc8d59", i)

# Each curve begins at (1, 1): its largest size and the error there.
array largest[words(curves)]
array worst[words(curves)]
do for [i = 1:words(curves)] {
  stats rows_of(word(curves, i)) using 3:(abs($5 - $4)) nooutput
  largest[i] = STATS_max_x
  worst[i] = STATS_max_y
}

set style line 10 lc "#808080" dt 2
set border 3
set tics out nomirror
set key samplen 2 spacing 1.1

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,640 font "sans,14" } else { set terminal svg noenhanced size 1500,640 font "sans,14" }
  set output picture.".".format
  set multiplot layout 1,2
  set key bottom right
  set title "Errors fall as the first and the second power of the size"
  set xlabel "size over the largest"
  set ylabel "error over that at the largest size"
  set logscale xy
  set xrange [0.1:1.2]
  set yrange [0.005:1.5]
  set xtics (0.125, 0.25, 0.5, 1)
  plot x with lines ls 10 title "first power", x**2 with lines ls 10 dt 3 title "second power", \
    for [i = 1:words(curves)] rows_of(word(curves, i)) using ($3 / largest[i]):(abs($5 - $4) / worst[i]) \
      with linespoints lw 2 pt 7 lc rgb colour(i) title word(titles, i)
  unset logscale
  set key top left
  set title "Vertical cut in clay: where it collapses"
  set xlabel "cell over the height of the cut"
  set ylabel "unit weight times height over cohesion"
  set xrange [0:0.14]
  set yrange [3.5:5.6]
  set xtics 0.02
  cut(kind) = sprintf("< grep '\tnumber_%s\t' %s/vertical_cut.tsv", kind, out)
  plot 3.7805 with lines ls 10 title "limit analysis, 3.775 to 3.786", \
    cut("2_none") using ($3 / 4):5 with linespoints lw 2 pt 7 lc rgb "#4575b4" title "2 x 2 points in a cell", \
    cut("2_B-bar") using ($3 / 4):5 with linespoints lw 2 pt 7 lc rgb "#1a9850" title "2 x 2 points and B-bar", \
    cut("1_none") using ($3 / 4):5 with linespoints lw 2 pt 7 lc rgb "#d73027" title "1 point in a cell"
  unset multiplot
  set output
}
