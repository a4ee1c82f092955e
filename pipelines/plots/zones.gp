# The zones on the slope's section: how far slides reach with which probability, and what stands there.
# usage: gnuplot -c zones.gp PICTURE CLASSES SURFACE RUN [STRUCTURES]
# writes PICTURE.png and PICTURE.svg from zoning's classes and structures and from mpmrun's --profile of run number RUN
picture = ARG1
classes = ARG2
surface = ARG3
run = ARG4
structures = ARG5
set datafile separator tab
set datafile commentschars "#"

# Crest and toe stand in the profile's provenance, the greatest height in its columns.
detail(name) = real(system("sed -n 's/^# ".name.": //p' ".surface))
crest = detail("crest_m")
toe = detail("toe_m")
stats surface using "initial_m" nooutput
top = STATS_max

# A distance of a quantity, or on a side, as x.
place(quantity, distance) = quantity eq "influence_m" ? crest - distance : toe + distance
place_on(side, distance) = side eq "crest" ? crest - distance : toe + distance

# A distance that no run could give (all diverged) counts as none.
known(name) = strcol(name) eq "nan" ? 0 : column(name)

# Where each quantity's last zone ends, and whether the sample bounds that from above.
stats classes using (strcol("quantity") eq "influence_m" ? (crest_is_told = strcol("ci_high_m") ne "unbounded", known("distance_m")) : NaN) nooutput
crest_reach = STATS_max
stats classes using (strcol("quantity") eq "runout_m" ? (toe_is_told = strcol("ci_high_m") ne "unbounded", known("distance_m")) : NaN) nooutput
toe_reach = STATS_max

# The picture ends beyond the last zone and the last structure.
crest_end = crest_reach
toe_end = toe_reach
if (structures ne "") {
  stats structures using (strcol("side") eq "crest" ? column("distance_m") : 0) nooutput
  crest_end = STATS_max > crest_end ? STATS_max : crest_end
  stats structures using (strcol("side") eq "toe" ? column("distance_m") : 0) nooutput
  toe_end = STATS_max > toe_end ? STATS_max : toe_end
}
left = crest - crest_end > 4 ? crest - crest_end - 4 : 0
right = toe + toe_end + 6
limit(quantity) = quantity eq "influence_m" ? left : right

# The five classes from pale to dark, grey where the sample cannot tell.
very_high = 0x99000d; high = 0xef3b2c; medium = 0xfc9272; low = 0xfee0b6; very_low = 0xfff7e0; untold = 0xdddddd
color(class) = class eq "very_high" ? very_high : class eq "high" ? high : class eq "medium" ? medium : class eq "low" ? low \
             : class eq "very_low" ? very_low : untold
spoken(class) = class eq "very_high" ? "very high" : class eq "very_low" ? "very low" : class

# A zone of `wanted` lies between `near`, the boundary before it, and `from`, its own; the first begins at crest or toe.
near = crest; from = crest
start(wanted, origin) = strcol("quantity") ne wanted ? NaN : \
  (near = strcol("class") eq "very_high" ? origin : from, from = place(wanted, known("distance_m")), near)
# They are drawn as a strip below the base.
strip_low = -0.26 * top
strip_high = -0.04 * top

# Below the strip, a line for each boundary: its distance and the 95 % interval of that, an arrow where there is no upper end.
line_y(probability) = -0.5 * top - 0.17 * top * int(0.5 - log10(probability))
is_bounded(name) = strcol(name) ne "unbounded"
near_end(quantity) = place(quantity, is_bounded("ci_low_m") ? column("ci_low_m") : 0)
far_end(quantity) = is_bounded("ci_high_m") ? place(quantity, column("ci_high_m")) : limit(quantity)
of(wanted, value) = strcol("quantity") eq wanted ? value : NaN

# Structures stand on the initial ground.
ground(side) = side eq "crest" ? top : 0
verdict(class, highest) = class eq highest ? spoken(class) : spoken(class).", perhaps ".spoken(highest)
text_on(side) = strcol("side") eq side ? strcol("name").": ".verdict(strcol("class"), strcol("class_high")) : ""

set size ratio -1
set xrange [left:right]
set yrange [line_y(0.001) - 0.1 * top:(structures eq "" ? 1.2 : 1.8) * top]
unset ytics
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen 0.9
set bmargin at screen 0.12
set key at screen 0.5, 0.99 center top maxrows 2 Left reverse samplen 1.5 font ",12"
set style fill solid noborder
x = 'place_on(strcol("side"), column("distance_m"))'

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,680 font "sans,14" } else { set terminal svg noenhanced size 1500,680 font "sans,14" }
  set output picture.".".format
  set multiplot
  set border 1
  set xtics out nomirror
  set xlabel "x (m)"
  set label 1 "crest" at crest, 1.08 * top right offset 1,0
  set label 2 "toe" at toe, 0.08 * top left
  set label 3 "share of runs that reach farther:" at (crest + toe) / 2, line_y(0.5) + 0.15 * top center font ",11"
  plot NaN with boxes fc rgb very_high title "very high: above 50 %", NaN with boxes fc rgb high title "high: above 10 %", \
    NaN with boxes fc rgb medium title "medium: above 1 %", NaN with boxes fc rgb low title "low: above 0.1 %", \
    NaN with boxes fc rgb very_low title "very low", \
    NaN with boxes fc rgb untold title "beyond all runs, too few to tell", \
    surface using "x_m":"initial_m" with filledcurves y1=0 fc rgb "#e3dccb" notitle, \
    0 with lines lc rgb "#5b4a2f" lw 2 notitle, \
    surface using "x_m":"initial_m" with lines lc rgb "#5b4a2f" lw 2 title "ground before", \
    surface using "x_m":"surface_m" with lines lc rgb "#08306b" lw 2 dt (8,5) title "ground after run ".run, \
    classes using (start("influence_m", crest)):(0):(near):(from):(strip_low):(strip_high):(color(strcol("class"))) \
      with boxxyerror fc rgb variable notitle, \
    classes using (start("runout_m", toe)):(0):(near):(from):(strip_low):(strip_high):(color(strcol("class"))) \
      with boxxyerror fc rgb variable notitle, \
    "+" every ::0::0 using (0):(0):(left):(crest - crest_reach):(strip_low):(strip_high) \
      with boxxyerror fc rgb (crest_is_told ? very_low : untold) notitle, \
    "+" every ::0::0 using (0):(0):(toe + toe_reach):(right):(strip_low):(strip_high) \
      with boxxyerror fc rgb (toe_is_told ? very_low : untold) notitle, \
    for [q in "influence_m runout_m"] classes \
      using (of(q, near_end(q))):(line_y(column("probability"))):(far_end(q) - near_end(q)):(0) \
      with vectors nohead lw 3 lc rgb "#555555" notitle, \
    for [q in "influence_m runout_m"] classes \
      using (is_bounded("ci_high_m") ? NaN : of(q, near_end(q))):(line_y(column("probability"))):\
            (far_end(q) - near_end(q)):(0) \
      with vectors head filled size 0.5,20 fixed lw 3 lc rgb "#555555" notitle, \
    for [q in "influence_m runout_m"] classes using (of(q, place(q, known("distance_m")))):(line_y(column("probability"))) \
      with points pt 7 ps 2 lc rgb "black" notitle, \
    for [q in "influence_m runout_m"] classes \
      using (of(q, place(q, known("distance_m")))):(line_y(column("probability"))):(color(strcol("class"))) \
      with points pt 7 ps 1.6 lc rgb variable notitle, \
    classes using (of("runout_m", (crest + toe) / 2)):(line_y(column("probability"))):(sprintf("%g %%", 100 * column("probability"))) \
      with labels font ",12" notitle
  unset border; unset xtics; unset xlabel; unset label
  if (structures ne "") {
    plot structures using (@x):(ground(strcol("side"))):(0):(0.2 * top) with vectors nohead lw 2 lc rgb "black" notitle, \
    structures using (@x):(ground(strcol("side")) + 0.2 * top) with points pt 5 ps 2 lc rgb "black" notitle, \
    structures using (@x):(ground(strcol("side")) + 0.2 * top):(color(strcol("class"))) with points pt 5 ps 1.5 lc rgb variable notitle, \
    structures using (strcol("side") eq "crest" ? @x : NaN):(1.31 * top):(text_on("crest")) with labels left rotate by 35 font ",12" notitle, \
    structures using (strcol("side") eq "toe" ? @x : NaN):(0.31 * top):(text_on("toe")) with labels right rotate by -35 font ",12" notitle
  }
  unset multiplot
  set output
}
