# Conditioned and correlated random fields against kriging, cokriging and variograms of R's package gstat.
load helper

setup() {
  cd "$BATS_TEST_TMPDIR"
  cat >scene.toml <<'END'
[slope]
height = "5 m"
length = "10 m"
angle = "90 deg"

[[soil]]
name = "clay"
unit_weight = "20 kN/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
cohesion = "20 kPa"
friction_angle = "30 deg"

[field.cohesion]
mean = "20 kPa"
cov = 0.25
marginal = "normal"
lag = "elliptical"
horizontal_scale = "4 m"
vertical_scale = "4 m"
cell = "0.5 m"

[field.friction_angle]
mean = "30 deg"
cov = 0.1
marginal = "normal"
lag = "elliptical"
horizontal_scale = "4 m"
vertical_scale = "4 m"
cell = "0.5 m"

[field.cross_correlation]
parameters = ["cohesion", "friction_angle"]
matrix = [[1, -0.6], [-0.6, 1]]
END
}

# moments DATASET UNIT: mean and variance of each of the 200 cells over 4000 samples, in that unit.
moments() {
  h5dump -A 0 -y -w 1 -m %.12g -d "/$1" fields.h5 | sed -n 's/^ *\([-0-9][-+.0-9e]*\),\{0,1\}$/\1/p' | awk -v unit="$2" '
    { cell = (NR - 1) % 200; v = $1 / unit; sum[cell] += v; squares[cell] += v * v; if (cell == 0) ++n }
    END { for (c = 0; c < 200; ++c) printf "%.9g\t%.9g\n", sum[c] / n, squares[c] / n - (sum[c] / n) ^ 2 }'
}

# in_r: the script on stdin; "grid" holds the cells in the order of the file.
in_r() {
  { echo 'suppressMessages({library(sp); library(gstat)}); grid <- expand.grid(x = 0.25 + 0.5 * 0:19, y = 0.25 + 0.5 * 0:9); coordinates(grid) <- ~x+y'; cat; } >script.R
  Rscript script.R
}

# Distances from the kriging mean in standard errors, and of the variance in those of a normal's: each is a standard normal, at the
# data none. Of 400 the largest exceeds 4.5 once in 300 studies.
judge='function(found, mean, variance, n) {
  inside <- variance > 1e-6
  cat(max(abs(found[!inside, 1] - mean[!inside])), max(abs(found[inside, 1] - mean[inside]) / sqrt(variance[inside] / n)),
      max(abs(found[inside, 2] / variance[inside] - 1) / sqrt(2 / n)), "\n") }'

@test "conditioned samples have mean and variance of gstat's simple kriging" {
  sed -i '/^\[field.friction_angle\]/,$d' scene.toml
  sed -i '/^\[field.cohesion\]/a measurements = "borings.tsv"' scene.toml
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 2.25 0.75 26 2.25 2.75 15 7.75 1.25 22.5 >borings.tsv
  rfgen scene.toml -n 4000 -o fields.h5
  moments cohesion 1000 >found.tsv
  in_r >distances <<END
judge <- $judge
d <- read.delim("borings.tsv"); d\$y <- 5 - d\$depth_m; coordinates(d) <- ~x_m+y
k <- krige(value_kPa ~ 1, d, SpatialPoints(coordinates(grid)), model = vgm(25, "Exp", 2), beta = 20, debug.level = 0)
judge(read.delim("found.tsv", header = FALSE), k\$var1.pred, k\$var1.var, 4000)
END
  read -r at_data of_mean of_variance <distances
  assert_between "$at_data" 0 1e-6
  assert_between "$of_mean" 1 4.5
  assert_between "$of_variance" 1 4.5
}

@test "correlated fields conditioned together have those of gstat's cokriging" {
  sed -i '/^\[field.cohesion\]/a measurements = "cohesion.tsv"' scene.toml
  sed -i '/^\[field.friction_angle\]/a measurements = "friction.tsv"' scene.toml
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 2.25 0.75 26 2.25 2.75 15 7.75 1.25 22.5 >cohesion.tsv
  printf '%s\t%s\t%s\n' x_m depth_m value_deg 4.75 0.75 34 7.75 3.25 27 >friction.tsv
  rfgen scene.toml -n 4000 -o fields.h5
  moments cohesion 1000 >cohesion
  moments friction_angle 0.017453292519943295 >friction
  in_r >distances <<END
judge <- $judge
a <- read.delim("cohesion.tsv"); a\$y <- 5 - a\$depth_m; coordinates(a) <- ~x_m+y
b <- read.delim("friction.tsv"); b\$y <- 5 - b\$depth_m; coordinates(b) <- ~x_m+y
g <- gstat(NULL, "a", value_kPa ~ 1, a, model = vgm(25, "Exp", 2), beta = 20)
g <- gstat(g, "b", value_deg ~ 1, b, model = vgm(9, "Exp", 2), beta = 30)
g <- gstat(g, c("a", "b"), model = vgm(-0.6 * 15, "Exp", 2))
k <- predict(g, SpatialPoints(coordinates(grid)), debug.level = 0)
judge(read.delim("cohesion", header = FALSE), k\$a.pred, k\$a.var, 4000)
judge(read.delim("friction", header = FALSE), k\$b.pred, k\$b.var, 4000)
END
  local at_data of_mean of_variance
  while read -r at_data of_mean of_variance; do
    assert_between "$at_data" 0 1e-6
    assert_between "$of_mean" 1 4.5
    assert_between "$of_variance" 1 4.5
  done <distances
  assert_equal "$(wc -l <distances)" 2
}

@test "variograms by gstat are those of the models" {
  # Over 400 samples, along x: 12.5 m x 5 m hold some 10 independent values, so that a semivariance of 25 (kPa)^2 scatters by some
  # 25 sqrt(2 / 10 / 400) = 0.6; four of these.
  sed -i '/^\[field.friction_angle\]/,$d' scene.toml
  rfgen scene.toml -n 400 -o fields.h5
  h5dump -A 0 -y -w 1 -m %.9g -d /cohesion fields.h5 | sed -n 's/^ *\([-0-9][-+.0-9e]*\),\{0,1\}$/\1/p' >values
  in_r >semivariances <<'END'
v <- matrix(scan("values", quiet = TRUE) / 1000, nrow = 200)
gamma <- sapply(1:400, function(k) { d <- SpatialPointsDataFrame(coordinates(grid), data.frame(v = v[, k]))
  variogram(v ~ 1, d, alpha = 90, tol.hor = 1, boundaries = c(0.6, 1.1, 1.6, 2.1, 3.1, 4.1))$gamma })
dist <- { d <- SpatialPointsDataFrame(coordinates(grid), data.frame(v = v[, 1])); variogram(v ~ 1, d, alpha = 90, tol.hor = 1, boundaries = c(0.6, 1.1, 1.6, 2.1, 3.1, 4.1))$dist }
m <- rowMeans(gamma)
for (i in seq_along(m)) cat(dist[i], m[i], 25 * (1 - exp(-dist[i] / 2)), "\n")
END
  local lag found expected
  while read -r lag found expected; do assert_near "$found" "$expected" 2.4; done <semivariances
  assert_equal "$(wc -l <semivariances)" 6
}
