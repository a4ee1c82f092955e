# Mean and standard deviation of the reach against the horizontal scale of fluctuation or the coefficient of variation, with 95 %
# intervals, and what the paper says (its Figs. 13 and 14).
# usage: gnuplot -c sweep.gp PICTURE SWEEP VERDICTS scale|cov      writes PICTURE.png and PICTURE.svg from pipelines/paper's tables
picture = ARG1
sweep = ARG2
verdicts = ARG3
axis = ARG4
set datafile separator tab
set datafile missing "nan"

# Of this sweep is a case, SCALEm_COV, whose other variable has its base value. The axis' column in SWEEP: scale 2, COV 3.
is_scale = axis eq "scale"
condition = is_scale ? "cov == 0.25" : "scale == 1"
cases = "split($1, part, \"m_\"); scale = part[1]; cov = part[2]; if (".condition.")"
ends = "$7 == \"unbounded\" ? $6 : $7, $8 == \"unbounded\" ? $6 : $8"
ours(quantity, statistic) = sprintf("< awk -F '\t' -v OFS='\t' '$4 == \"%s\" && $5 == \"%s\" { %s print %s, $6, ".ends." }' %s | sort -g", \
  quantity, statistic, cases, axis, sweep)
theirs(quantity, statistic) = sprintf("< awk -F '\t' -v OFS='\t' '$3 == \"%s\" && $4 == \"%s\" { %s print %s, $5 }' %s", \
  quantity, statistic, cases, axis, verdicts)

set border 3
set tics out nomirror
set grid ytics lc "#dddddd" lw 1 lt 1
set style line 1 lc rgb "#08306b" lw 2 pt 7 ps 1.2
set style line 2 lc rgb "#d95f02" lw 2 pt 9 ps 1.8
if (axis eq "scale") { set xtics (1, 6, 12, 24, 48) } else { set xtics (0.1, 0.2, 0.25, 0.4, 0.5) }

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,900 font "sans,14" } else {
    set terminal svg noenhanced size 1500,900 font "sans,14" }
  set output picture.".".format
  set multiplot layout 2,2 margins 0.07,0.97,0.09,0.94 spacing 0.08,0.13
  do for [statistic in "mean sd"] {
    do for [quantity in "influence_m runout_m"] {
      reach = quantity eq "influence_m" ? "influence distance I" : "runout distance R"
      set title (statistic eq "mean" ? "Mean of the " : "Standard deviation of the ").reach
      set xlabel statistic eq "sd" ? (axis eq "scale" ? "horizontal scale of fluctuation (m)" : "coefficient of variation") : ""
      set ylabel quantity eq "influence_m" ? "m" : ""
      # The first panel leaves room for the key.
      is_first = statistic eq "mean" && quantity eq "influence_m"
      if (is_first) { set key top left Left reverse samplen 2 } else { unset key }
      set offsets graph 0.04, graph 0.04, graph (is_first ? 0.3 : 0.08), graph 0.08
      plot ours(quantity, statistic) using 1:2:3:4 with yerrorlines ls 1 title "here, with 95 % intervals", \
           theirs(quantity, statistic) using 1:2 with points ls 2 title "paper"
    }
  }
  unset multiplot
  set output
}
