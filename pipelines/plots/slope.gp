# The slope before and after one run, each material point coloured by its plastic strain at the end.
# usage: gnuplot -c slope.gp PICTURE SHOWN      writes PICTURE.png and PICTURE.svg from SHOWN/points.tsv (mpmrun --table)
picture = ARG1
points = ARG2."/points.tsv"
set datafile separator tab
set datafile commentschars "#"

# Points are drawn as squares. The lattice starts half a spacing from the corner of the slope; sheared soil spreads, and its squares are
# larger so as to close the gaps.
stats points using "x0_m" nooutput; half_x = 1.25 * STATS_min  # overlapping a little, against seams
stats points using "y0_m" nooutput; half_y = 1.25 * STATS_min; top = STATS_max + STATS_min
stats points using "x_m" nooutput; right = STATS_max

set palette defined (0 "#e8e4d8", 0.25 "#9ecae1", 0.5 "#4575b4", 0.75 "#6a3d9a", 1 "#2d004b")
set logscale cb
set cbrange [0.01:10]
set format cb "%g"
set cblabel "equivalent plastic strain"
set size ratio -1
set xrange [0:right + 1]
set yrange [0:1.15 * top]
set xtics 5 out nomirror
set ytics 1 out nomirror
set ylabel "y (m)"
set border 3
set style fill solid noborder
strain(value) = value < 0.01 ? 0.01 : value

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,560 font "sans,14" } else { set terminal svg noenhanced size 1500,560 font "sans,14" }
  set output picture.".".format
  set multiplot
  set lmargin at screen 0.06; set rmargin at screen 0.90
  unset colorbox
  unset xlabel
  set tmargin at screen 0.99; set bmargin at screen 0.58
  set title "Before: where the strain of the slide will be" offset 0,-0.5
  plot points using "x0_m":"y0_m":(half_x):(half_y):(strain(column("plastic_strain"))) with boxxyerror lc palette notitle
  set colorbox user origin 0.92,0.12 size 0.015,0.8
  set xlabel "x (m)"
  set tmargin at screen 0.54; set bmargin at screen 0.13
  set title "After: where the soil came to rest"
  plot points using "x_m":"y_m":(1.2 * half_x):(1.2 * half_y):(strain(column("plastic_strain"))) with boxxyerror lc palette notitle
  unset multiplot
  set output
}
