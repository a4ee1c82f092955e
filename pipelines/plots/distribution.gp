# How the reach of the runs that slid is distributed: histogram, densities and cumulatives of the fits (the paper's Figs. 12 and 13).
# usage: gnuplot -c distribution.gp PICTURE HISTOGRAM DENSITIES      writes PICTURE.png and PICTURE.svg from mcstats --histogram, --densities
picture = ARG1
histogram = ARG2
densities = ARG3
set datafile separator tab
set datafile commentschars "#"

of(quantity, value) = strcol("quantity") eq quantity ? value : NaN
has_slides = int(system("awk '$1 == \"runout_m\"' '".densities."' | wc -l")) > 0

array family[5] = ["normal", "lognormal", "gamma", "weibull", "gev"]
array name[5] = ["Normal", "Lognormal", "Gamma", "Weibull", "GEV"]
array colour[5] = ["#d95f02", "#7570b3", "#1b9e77", "#666666", "#a6761d"]
array dash[5] = [1, 2, 4, 3, 5]

set border 3
set autoscale xfix
set xtics out nomirror
set ytics out nomirror
set style fill solid 1 border lc "#ffffff"
if (!has_slides) { set xrange [0:1]; set label 1 "no run slid" at graph 0.5, 0.5 center }

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,900 font "sans,14" } else { set terminal svg noenhanced size 1500,900 font "sans,14" }
  set output picture.".".format
  set multiplot layout 2,2 margins 0.07,0.97,0.08,0.94 spacing 0.07,0.12
  do for [kind in "density cumulative"] {
    do for [panel in "influence_m runout_m"] {
      set title (panel eq "influence_m" ? "Influence distance I" : "Runout distance R").(kind eq "density" ? ": density (1/m)" : ": share at or below")
      set xlabel kind eq "cumulative" ? "m" : ""
      if (kind eq "density") { set key top right Left reverse samplen 3 } else { set key top left Left reverse samplen 3 }
      set yrange [0:*]
      if (kind eq "cumulative" || !has_slides) { set yrange [0:1] }
      if (!has_slides) { plot NaN notitle; continue }
      if (kind eq "density") {
        plot histogram using (of(panel, (column("low_m") + column("high_m")) / 2)):"density":(column("high_m") - column("low_m")) \
               with boxes lc "#c6dbef" title "runs", \
             for [i = 1:5] densities using (of(panel, column("distance_m"))):(of(panel, column(family[i]."_density"))) with lines lc rgb colour[i] lw 2 dt dash[i] title name[i]
      } else {
        plot densities using (of(panel, column("distance_m"))):(of(panel, column("empirical_cumulative"))) with lines lc "#08306b" lw 3 title "runs", \
             for [i = 1:5] densities using (of(panel, column("distance_m"))):(of(panel, column(family[i]."_cumulative"))) with lines lc rgb colour[i] lw 2 dt dash[i] title name[i]
      }
    }
  }
  unset multiplot
  set output
}
