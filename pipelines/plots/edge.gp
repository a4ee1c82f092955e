# The longest stable step by method, points in a cell, body and Poisson's ratio: found, by the spectrum of the step, and what mpmrun takes.
# usage: gnuplot -c edge.gp PICTURE EDGES      writes PICTURE.png and PICTURE.svg from the tables of tests/verification/edge.cpp
picture = ARG1
edges = ARG2
set datafile separator tab
methods = "MUSL_GIMP MUSL_GIMP_B-bar USF_GIMP MUSL_linear USF_linear USL_GIMP USL_GIMP_B-bar"
cases = system("awk 'NR > 1 && !seen[$1]++ { print $1 }' ".edges)
of(name) = sprintf("< grep '^%s[[:blank:]]' %s", name, edges)
points(name) = int(name[strlen(name):])
method(name) = sum [k = 1:words(methods)] (word(methods, k) eq name[1:strlen(name) - 2] ? k : 0)
colour(points) = points == 1 ? 0x4575b4 : points == 2 ? 0xd73027 : 0x1a9850
shape(points) = points == 1 ? 7 : points == 2 ? 5 : 9
# beside one another within a method: 1, 2 and 4 points, and for each the rows of its table
place(name, row) = method(name) - 0.36 + 0.26 * (points(name) == 1 ? 0 : points(name) == 2 ? 1 : 2) + 0.018 * row
set border 3
set tics out nomirror
set xtics nomirror scale 0
set key top right
set rmargin 4
set bmargin 4.5
set ylabel "longest stable step over cell / wave speed"
set yrange [0:3]
set xrange [0.5:words(methods) + 0.5]
do for [k = 1:words(methods)] { set xtics add (system(sprintf("echo %s | tr _ '\\n'", word(methods, k))) k) }
do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1100,600 font "sans,14" } else { set terminal svg noenhanced size 1100,600 font "sans,14" }
  set output picture.".".format
  plot for [name in cases] of(name) using (place(name, $0)):($5 * $7) with points pt shape(points(name)) ps 1.1 lc rgb colour(points(name)) notitle, \
    for [name in cases] of(name) using (place(name, $0)):($4 * $7) with points pt 1 ps 0.9 lw 1.5 lc rgb "#202020" notitle, \
    for [name in cases] of(name) using (place(name, $0) - 0.009):7:(0.018):(0) with vectors nohead lw 2 lc rgb "#808080" notitle, \
    for [number in "1 2 4"] NaN with points pt shape(int(number)) ps 1.4 lc rgb colour(int(number)) title "found, ".number." x ".number." points in a cell", \
    NaN with points pt 1 ps 1.4 lw 1.5 lc rgb "#202020" title "by the spectrum of the step", \
    NaN with lines lw 2 lc rgb "#808080" title "the limit that mpmrun keeps to"
  set output
}
