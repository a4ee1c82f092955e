# Random fields in tests of rfgen and rfmap: scenes made from the demo's, and numbers read from HDF5 files by h5dump.

setup() {
  cd "$BATS_TEST_TMPDIR"
  scene=$TOP/pipelines/demo/scene.toml
}

# h5_numbers FILE DATASET [h5dump options]: the numbers, one per line.
h5_numbers() { h5dump -A 0 -y -w 1 -m %.17g -d "$2" "${@:3}" "$1" | sed -n 's/^ *\(-\{0,1\}[0-9][-+.0-9e]*\),\{0,1\}$/\1/p'; }

# sample FILE INDEX: the values of one sample.
sample() { h5_numbers "$1" /cohesion -s "$2,0,0" -c 1,50,250; }

# with LINES: the demo's scene with these lines in its field, and without its autocorrelation.
with() { sed "s/^autocorrelation = .*/$1/" "$scene" >with.toml; }

# varied FILE: the scene of tests/scenes/varied.toml with 200 samples.
varied() { sed 's/^realizations = 4/realizations = 200/' "$TOP/tests/scenes/varied.toml" >"$1"; }

# two_soils: the demo's scene with a crust above 2 m and a clay below, of residual cohesion 18 and 12 kPa.
two_soils() {
  sed '/^\[\[soil\]\]/,/^$/d' "$scene"
  cat <<END

[[soil]]
name = "crust"
unit_weight = "18 kN/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.33
cohesion = "30 kPa"
residual_cohesion = "18 kPa"
softening_threshold = 0.1
softening_shape = 8

[[soil]]
name = "clay"
top = [["0 m", "2 m"], ["30 m", "2 m"]]
unit_weight = "20 kN/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.33
cohesion = "20 kPa"
residual_cohesion = "12 kPa"
softening_threshold = 0.1
softening_shape = 8
END
}
