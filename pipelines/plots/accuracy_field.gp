# Error of the covariance of random fields against the time of a thousand samples and against memory, by method and mesh.
# usage: gnuplot -c accuracy_field.gp PICTURE TABLE      writes PICTURE.png and PICTURE.svg from pipelines/accuracy's field.tsv
picture = ARG1
table = ARG2
set datafile separator tab

# A curve for each lag and method, from coarse meshes to fine ones.
kinds = system("awk -F '\t' 'NR > 1 && !seen[$1 \"/\" $2]++ { print $1 \"/\" $2 }' '".table."'")
lag(kind) = kind[1:strstrt(kind, "/") - 1]
method(kind) = kind[strstrt(kind, "/") + 1:*]
rows_of(kind) = sprintf("< grep '^%s\t%s\t' '%s'", lag(kind), method(kind), table)
colour(kind) = method(kind) eq "separable" ? "#08306b" : method(kind) eq "circulant" ? "#1b9e77" : method(kind) eq "Cholesky" ? "#7570b3" : "#d95f02"
mark(kind) = method(kind) eq "separable" ? 7 : method(kind) eq "circulant" ? 5 : method(kind) eq "Cholesky" ? 11 : 9
dash(kind) = lag(kind) eq "separable" ? 1 : 2

set border 3
set tics out nomirror
set logscale xy
set grid lc "#dddddd" lw 1 lt 1
set key top right samplen 3 spacing 1.1
set ylabel "largest error of the covariance, of variance 1"
set yrange [0.002:0.2]

do for [format in "png svg"] {
  if (format eq "png") { set terminal pngcairo noenhanced size 1500,640 font "sans,14" } else { set terminal svg noenhanced size 1500,640 font "sans,14" }
  set output picture.".".format
  set multiplot layout 1,2
  do for [place in "6 7"] {
    if (place eq "6") { unset key } else { set key; set xrange [5:3000] }
    set xlabel place eq "6" ? "time of the samples (s)" : "peak memory (MiB)"
    plot for [kind in kinds] rows_of(kind) using (column(int(place))):4 with linespoints lw 2 dt dash(kind) lc rgb colour(kind) pt mark(kind) ps 1.3 \
      title method(kind).", ".lag(kind)
    set ylabel ""
  }
  set xrange [*:*]
  set ylabel "largest error of the covariance, of variance 1"
  unset multiplot
  set output
}
