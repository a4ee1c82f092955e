# Samples of a scene's random fields against theory: correlations at lags, mean and COV of each field, and cross-correlations.
# usage: gnuplot -c check.gp PICTURE TABLE      writes PICTURE.png and PICTURE.svg from TABLE, written by rfgen SCENE --check
picture = ARG1
table = ARG2
set datafile separator tab
set datafile commentschars "#"

names(quantity) = system(sprintf("awk -F '\\t' '$2 == \"%s\" && !seen[$1]++ { printf \"%%s\\n\", $1 }' '%s'", quantity, table))
fields = names("mean")
pairs = names("cross_correlation")
count(list) = strlen(list) == 0 ? 0 : int(system(sprintf("printf '%%s\\n' '%s' | wc -l", list)))
nth(list, n) = system(sprintf("printf '%%s\\n' '%s' | sed -n %dp", list, n))
rows = count(fields) + (count(pairs) > 0)

is(name, quantity) = strcol("field") eq name && strcol("quantity") eq quantity
lag(name, along, across, value) = is(name, "correlation") && column(along) > 0 && column(across) == 0 ? value : NaN
share(n, value) = is(name, word("mean cov", n)) ? value : NaN


set border 3
set xtics out nomirror
set ytics out nomirror

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1200,360*rows font "sans,12" } else { set terminal svg noenhanced size 1200,360*rows font "sans,12" }
  set output picture.".".format
  set multiplot layout rows, 2 margins 0.06, 0.97, 0.2/rows, 1 - 0.1/rows spacing 0.08, 0.28/rows
  do for [i = 1:count(fields)] {
    name = nth(fields, i)
    set title name.": correlation of the Gaussian field"
    set xlabel "lag (m)"
    set xrange [0:*]
    set yrange [*<0:1]
    set xtics auto
    set key top right Right samplen 2
    plot table using "lag_x_m":(lag(name, "lag_x_m", "lag_y_m", column("theory"))) with lines lc "#d95f02" lw 1.5 title "theory along x", \
         table using "lag_y_m":(lag(name, "lag_y_m", "lag_x_m", column("theory"))) with lines lc "#1b6ca8" lw 1.5 title "along y", \
         table using "lag_x_m":(lag(name, "lag_x_m", "lag_y_m", column("estimate"))):(lag(name, "lag_x_m", "lag_y_m", column("ci_low"))):(lag(name, "lag_x_m", "lag_y_m", column("ci_high"))) with yerrorbars lc "#d95f02" pt 7 ps 0.8 title "samples along x", \
         table using "lag_y_m":(lag(name, "lag_y_m", "lag_x_m", column("estimate"))):(lag(name, "lag_y_m", "lag_x_m", column("ci_low"))):(lag(name, "lag_y_m", "lag_x_m", column("ci_high"))) with yerrorbars lc "#1b6ca8" pt 6 ps 0.8 title "along y"
    set title name.": values, as shares of theory"
    set xlabel ""
    set xrange [0.5:2.5]
    set yrange [*:*]
    set xtics ("mean" 1, "COV" 2)
    unset key
    plot table using (share(1, 0.5)):(share(1, 1)):(2):(0) with vectors nohead lc "#d95f02", \
         for [n = 1:2] table using (share(n, n)):(share(n, column("estimate")/column("theory"))):(share(n, column("ci_low")/column("theory"))):(share(n, column("ci_high")/column("theory"))) with yerrorbars lc "#333333" pt 7 ps 0.8
  }
  if (count(pairs) > 0) {
    set title "Cross-correlations of the Gaussian fields"
    set xrange [-1:1]
    set yrange [count(pairs) + 1:0]
    set xtics auto
    set ytics ("" 0)
    do for [i = 1:count(pairs)] { set ytics add (nth(pairs, i) i) }
    set key outside right
    place(name, i) = is(name, "cross_correlation") ? i : NaN
    set lmargin at screen 0.3
    set rmargin at screen 0.8
    plot for [i = 1:count(pairs)] table using "theory":(place(nth(pairs, i), i)) with points lc "#d95f02" pt 2 ps 2 title (i == 1 ? "theory" : ""), \
         for [i = 1:count(pairs)] table using "estimate":(place(nth(pairs, i), i)):"ci_low":"ci_high" with xerrorbars lc "#333333" pt 7 ps 0.8 title (i == 1 ? "samples" : "")
    unset lmargin
    unset rmargin
    set ytics auto
  }
  unset multiplot
  set output
}
