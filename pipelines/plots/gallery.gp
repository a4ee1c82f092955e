# One sample of each model of a random field, drawn to scale.
# usage: gnuplot -c gallery.gp PICTURE FOLDER      writes PICTURE.png and PICTURE.svg from FOLDER/panels.tsv (name, title, columns, rows)
#        and FOLDER/NAME.bin (float64, row by row from the base up)
picture = ARG1
folder = ARG2
width = 20.   # m, of every sample
height = 5.
set datafile separator tab
stats folder."/panels.tsv" using 3 nooutput
panels = STATS_records

set border 0
unset xtics
unset ytics
unset colorbox
set size ratio -1
set xrange [0:width]
set yrange [0:height]
set cbrange [8:36]
set palette defined (0 "#2c2a5e", 1 "#3d65a5", 2 "#63aaa4", 3 "#c9dfa0", 4 "#f6f3d5", 5 "#f0b765", 6 "#c8562f", 7 "#701c1f")

field(row, column) = system(sprintf("sed -n %dp '%s/panels.tsv' | cut -f %d", row, folder, column))

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,520 font "sans,12" } else { set terminal svg noenhanced size 1500,520 font "sans,12" }
  set output picture.".".format
  rows = (panels + 3) / 4
  set multiplot layout rows, 4 margins 0.01, 0.92, 0.02, 0.95 spacing 0.012, 0.06
  do for [panel = 1:panels] {
    columns = int(field(panel, 3))
    lines = int(field(panel, 4))
    set title field(panel, 2) offset 0,-0.7
    if (panel == panels) {
      set colorbox user origin 0.932, 0.1 size 0.012, 0.8
      set cblabel "cohesion (kPa)"
      set cbtics out
    }
    plot folder."/".field(panel, 1).".bin" binary array=(columns, lines) dx=width/columns dy=height/lines origin=(width/columns/2, height/lines/2) \
         format="%float64" endian=little using ($1 / 1000) with image notitle
  }
  unset multiplot
  unset colorbox
  unset cblabel
  set output
}
