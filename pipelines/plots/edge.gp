# The longest stable step over the limit that mpmrun keeps to, by body, points in a cell and Poisson's ratio.
# usage: gnuplot -c edge.gp PICTURE EDGES      writes PICTURE.png and PICTURE.svg from the table of tests/verification/edge.cpp
picture = ARG1
edges = ARG2
set datafile separator tab
of(points) = sprintf("< grep '^edge_%d_points' %s | sed 's/_nu_/, nu /; s/edge_//'", points, edges)
set style line 1 lc rgb "#4575b4" pt 7 ps 1.4
set style line 2 lc rgb "#d73027" pt 5 ps 1.4
set style line 4 lc rgb "#1a9850" pt 9 ps 1.4
set border 3
set tics out nomirror
set key bottom right
set rmargin 4
set ylabel "longest stable step over the limit"
set yrange [0:2.5]
set xrange [-0.5:11.5]
place(name) = 3 * ((strstrt(name, "column") > 0) + 2 * (strstrt(name, "strip") > 0) + 3 * (strstrt(name, "scattered") > 0)) + \
  (strstrt(name, "0.33") > 0) + 2 * (strstrt(name, "0.49") > 0)
set xtics rotate by 35 right
do for [i = 0:11] { set xtics add (sprintf("%s, nu %s", word("block column strip scattered", i / 3 + 1), word("0 0.33 0.49", i % 3 + 1)) i) }
do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1000,560 font "sans,14" } else { set terminal svg noenhanced size 1000,560 font "sans,14" }
  set output picture.".".format
  plot 1 with lines dt 2 lc "#808080" title "the limit that mpmrun keeps to", for [points in "1 2 4"] of(int(points)) using (place(strcol(2))):5 with points \
    ls int(points) title points." x ".points." points in a cell"
  set output
}
