# Exceedance curves: how probable it is that a slide reaches farther than a distance, behind the crest and in front of the toe.
# usage: gnuplot -c exceedance.gp PICTURE CURVE      writes PICTURE.png and PICTURE.svg from zoning's curve
picture = ARG1
curve = ARG2
set datafile separator tab
set datafile commentschars "#"

# Steps of the sample and its band end at `floor`: on a logarithmic axis there is no zero.
floor = 5e-4
at_least(value) = value < floor ? floor : value
of(quantity, value) = strcol("quantity") eq quantity ? value : NaN

# Names of the five classes, halfway between their ends.
array class[5] = ["very high", "high", "medium", "low", "very low"]
array class_y[5] = [0.7, 0.22, 0.032, 0.0032, 0.0007]

set logscale y
set yrange [floor:1.3]
set ytics ("100 %%" 1, "50 %%" 0.5, "10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 0.001)
set grid ytics lc "#bbbbbb" lw 1 lt 1
set grid front
set border 3
set xtics out nomirror
set ytics out nomirror
set key bottom left Left reverse samplen 2 spacing 1.2
set style fill solid 1 noborder

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,620 font "sans,14" } else { set terminal svg noenhanced size 1500,620 font "sans,14" }
  set output picture.".".format
  set multiplot layout 1,2 margins 0.08,0.92,0.13,0.92 spacing 0.07
  do for [panel in "influence_m runout_m"] {
    is_crest = panel eq "influence_m"
    set title is_crest ? "Behind the crest: influence distance I" : "In front of the toe: runout distance R"
    set xlabel "distance (m)"
    set ylabel is_crest ? "probability that a slide reaches farther" : ""
    if (is_crest) { set key; unset label } else { unset key; do for [i = 1:5] { set label i class[i] at graph 1.02, first class_y[i] } }
    plot curve using "distance_m":(of(panel, at_least(column("ci_low")))):(of(panel, at_least(column("ci_high")))) \
           with filledcurves lc "#c6dbef" title "95 % band", \
         curve using "distance_m":(of(panel, column("normal"))) with lines lc "#d95f02" lw 2 dt (12,6) title "Normal fit", \
         curve using "distance_m":(of(panel, column("lognormal"))) with lines lc "#7570b3" lw 2 dt (3,5) title "Lognormal fit", \
         curve using "distance_m":(of(panel, column("probability") > 0 ? column("probability") : NaN)) \
           with lines lc "#08306b" lw 3 title "runs"
  }
  unset multiplot
  set output
}
