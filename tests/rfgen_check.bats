# rfgen --check: samples held against theory.
load helper
load fields

@test "--check holds samples against theory and says so" {
  rfgen "$scene" --check -n 200 -o check.tsv
  assert_schema field-check check.tsv
  assert_file_contains check.tsv '^# verdict: all 18 rows agree$'
  assert_equal "$(tsv_value quantity <check.tsv)" mean
  assert_near "$(tsv_value theory <check.tsv)" 20000 1e-3
  # Lags of 1 m along y: exp(-2).
  assert_near "$(awk -F '\t' '$2 == "correlation" && $4 == 1 { print $5 }' check.tsv)" 0.135335283 1e-9
  varied varied.toml
  rfgen varied.toml --check -o check.tsv
  assert_schema field-check check.tsv
  assert_file_contains check.tsv '^# verdict: all [0-9]* rows agree$'
  assert_near "$(awk -F '\t' '$1 == "cohesion, unit_weight" { print $5 }' check.tsv)" 0.2 1e-12
}

@test "--check knows floors, bedding, nuggets and averages over cells" {
  sed 's/^cov = .*/cov = 0.8/' "$scene" >floored.toml
  with 'lag = "elliptical"\nbedding_angle = "30 deg"\nnugget = 0.2'
  sed 's/^autocorrelation.*/average = "cell"/; s/^cell = "0.1 m"/cell = "0.5 m"/' "$scene" >averaged.toml
  for file in floored.toml with.toml averaged.toml; do
    rfgen "$file" --check -n 200 -o check.tsv
    assert_file_contains check.tsv '^# verdict: all [0-9]* rows agree$'
  done
  assert_near "$(tsv_value theory 2 <check.tsv)" 0.182656 1e-6 # sqrt(exp(zeta^2 gamma^2) - 1), zeta = .246220677, gamma = .735758882 of half a scale
}

@test "--check says what of the scene it leaves out" {
  rfgen "$scene" --check -n 20 -o check.tsv
  assert_file_contains check.tsv '^# drawn: as the scene says$'
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/; s/^realizations = .*/&\ndesign = "antithetic"/' "$scene" >scene.toml
  rfgen scene.toml --check -n 20 -o check.tsv
  assert_file_contains check.tsv '^# drawn: without its measurements and the design "antithetic"$'
  assert_schema field-check check.tsv
}

@test "--check sees what a cut-off expansion loses" {
  with 'method = "Karhunen-Loeve"\nvariance_kept = 0.5'
  rfgen with.toml --check -n 100 -o check.tsv
  assert_file_contains check.tsv '^# verdict: [0-9]* of 18 rows disagree$'
}

@test "--check with too few samples, or beside --explain, exits 64" {
  run rfgen "$scene" --check -n 5
  assert_failure 64
  assert_output --partial "--check wants at least 20 samples, found 5"
  run rfgen "$scene" --check --explain
  assert_failure 64
}
