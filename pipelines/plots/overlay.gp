# Exceedance curves of several studies and the worst case over them, on the slope's section with its zones and structures (the source
# paper's Fig. 15).
# usage: gnuplot -c overlay.gp PICTURE CURVES CLASSES STRUCTURES SURFACE
# writes PICTURE.png and PICTURE.svg from zoning's tables of several studies and from mpmrun's --profile of any run of the slope
picture = ARG1
curves = ARG2
classes = ARG3
structures = ARG4
surface = ARG5
set datafile separator tab
set datafile commentschars "#"

detail(name) = real(system("sed -n 's/^# ".name.": //p' ".surface))
crest = detail("crest_m")
toe = detail("toe_m")
stats surface using "initial_m" nooutput
top = STATS_max
place(quantity, distance) = quantity eq "influence_m" ? crest - distance : toe + distance
place_on(side, distance) = side eq "crest" ? crest - distance : toe + distance

# The studies in the table's order; the last is the worst case.
names = system("awk -F '\t' '!/^#/ && $1 != \"study\" && !seen[$1]++ { printf \"%s \", $1 }' ".curves)
studies = words(names) - 1
# Colours of Okabe and Ito (2008), told apart by colour-blind readers, and dashes for those who print in grey.
colour(i) = word("#0072b2 #e69f00 #009e73 #cc79a7 #56b4e9 #d55e00", (i - 1) % 6 + 1)

# Zones of the worst case: from the boundary before to the own one.
very_high = 0x99000d; high = 0xef3b2c; medium = 0xfc9272; low = 0xfee0b6; very_low = 0xfff7e0
color(class) = class eq "very_high" ? very_high : class eq "high" ? high : class eq "medium" ? medium : class eq "low" ? low : very_low
known(name) = strcol(name) eq "nan" ? 0 : column(name)
near = crest; from = crest
start(wanted, origin) = strcol("study") ne "worst_case" || strcol("quantity") ne wanted ? NaN : \
  (near = strcol("class") eq "very_high" ? origin : from, from = place(wanted, known("distance_m")), near)
worst(quantity) = strcol("study") eq "worst_case" && strcol("quantity") eq quantity ? known("distance_m") : 0
stats classes using (worst("influence_m")) nooutput; crest_end = STATS_max
stats classes using (worst("runout_m")) nooutput; toe_end = STATS_max
crest_reach = crest_end; toe_reach = toe_end
stats structures using (strcol("side") eq "crest" ? column("distance_m") : 0) nooutput
crest_end = STATS_max > crest_end ? STATS_max : crest_end
stats structures using (strcol("side") eq "toe" ? column("distance_m") : 0) nooutput
toe_end = STATS_max > toe_end ? STATS_max : toe_end
left = crest - crest_end > 2 ? crest - crest_end - 2 : 0
right = toe + toe_end + 4

floor = 5e-4
of(study, quantity, value) = strcol("study") eq study && strcol("quantity") eq quantity && value >= floor ? value : NaN
spoken(class) = class eq "very_high" ? "very high" : class eq "very_low" ? "very low" : class
verdict(class, highest) = class eq highest ? spoken(class) : spoken(class)." (perhaps ".spoken(highest).")"
ground(side) = side eq "crest" ? top : 0
x = 'place_on(strcol("side"), column("distance_m"))'
is_worst(value) = strcol("study") eq "worst_case" ? value : NaN

set xrange [left:right]
set border 3
set tics out nomirror
set lmargin at screen 0.09
set rmargin at screen 0.98
set style fill solid noborder

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,1000 font "sans,14" } else {
    set terminal svg noenhanced size 1500,1000 font "sans,14" }
  set output picture.".".format
  set multiplot

  set tmargin at screen 0.86
  set bmargin at screen 0.44
  set logscale y
  set yrange [floor:1]
  set ytics ("100 %%" 1, "50 %%" 0.5, "10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 0.001)
  set grid ytics lc "#888888" lw 1 lt 1
  set grid front
  set format x ""
  set xlabel ""
  set ylabel "probability that a slide reaches farther"
  set key at screen 0.53, 0.995 center top maxrows 4 Left reverse samplen 3 font ",12"
  plot NaN with boxes fc rgb very_high title "very high: above 50 %", NaN with boxes fc rgb high title "high: above 10 %", \
    NaN with boxes fc rgb medium title "medium: above 1 %", NaN with boxes fc rgb low title "low: above 0.1 %", \
    classes using (start("influence_m", crest)):(floor):(near):(from):(floor):(1):(color(strcol("class"))) \
      with boxxyerror fc rgb variable fs transparent solid 0.35 notitle, \
    classes using (start("runout_m", toe)):(floor):(near):(from):(floor):(1):(color(strcol("class"))) \
      with boxxyerror fc rgb variable fs transparent solid 0.35 notitle, \
    for [q in "influence_m runout_m"] curves using (place(q, column("distance_m"))):(of("worst_case", q, column("probability"))) \
      with lines lw 9 lc rgb "#aaaaaa" title (q eq "runout_m" ? "worst case of all" : ""), \
    for [i = 1:studies] for [q in "influence_m runout_m"] curves \
      using (place(q, column("distance_m"))):(of(word(names, i), q, column("probability"))) \
      with lines lw 3 dt i lc rgb colour(i) title (q eq "runout_m" ? word(names, i) : "")
  unset logscale
  unset grid
  unset key
  unset ylabel
  unset ytics

  # The section at the same scale of x; heights are exaggerated where the picture asks for it.
  set tmargin at screen 0.42
  set bmargin at screen 0.09
  set border 1
  set yrange [-0.35 * top:3.3 * top]
  set format x "%g"
  set xlabel "x (m)"
  set label 1 "crest" at crest, 1.1 * top right offset -0.5,0
  set label 2 "toe" at toe, 0.12 * top left offset 0.5,0
  plot surface using "x_m":"initial_m" with filledcurves y1=0 fc rgb "#e3dccb", \
    surface using "x_m":"initial_m" with lines lc rgb "#5b4a2f" lw 2, \
    0 with lines lc rgb "#5b4a2f" lw 2, \
    classes using (start("influence_m", crest)):(0):(near):(from):(-0.3 * top):(-0.06 * top):(color(strcol("class"))) \
      with boxxyerror fc rgb variable, \
    classes using (start("runout_m", toe)):(0):(near):(from):(-0.3 * top):(-0.06 * top):(color(strcol("class"))) \
      with boxxyerror fc rgb variable, \
    "+" every ::0::0 using (0):(0):(left):(crest - crest_reach):(-0.3 * top):(-0.06 * top) \
      with boxxyerror fc rgb very_low, \
    "+" every ::0::0 using (0):(0):(toe + toe_reach):(right):(-0.3 * top):(-0.06 * top) \
      with boxxyerror fc rgb very_low, \
    structures using (is_worst(@x)):(ground(strcol("side"))):(0):(0.3 * top) with vectors nohead lw 2 lc rgb "black", \
    structures using (is_worst(@x)):(ground(strcol("side")) + 0.3 * top) with points pt 5 ps 2.4 lc rgb "black", \
    structures using (is_worst(@x)):(ground(strcol("side")) + 0.3 * top):(color(strcol("class"))) with points pt 5 ps 1.8 lc rgb variable, \
    structures using (is_worst(@x)):(ground(strcol("side")) + 0.62 * top):(strcol("name")) with labels font ",15", \
    structures using (strcol("side") eq "crest" ? is_worst(@x) : NaN):(1.85 * top):(verdict(strcol("class"), strcol("class_high"))) \
      with labels left rotate by 30 font ",12", \
    structures using (strcol("side") eq "toe" ? is_worst(@x) : NaN):(0.85 * top):(verdict(strcol("class"), strcol("class_high"))) \
      with labels right rotate by -30 font ",12"
  unset label
  set border 3
  unset multiplot
  set output
}
