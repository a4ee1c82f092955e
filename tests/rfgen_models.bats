# rfgen: methods, marginal distributions, several fields at once.
load helper
load fields

# ---- methods ----

@test "--explain names the method and the reason, and draws nothing" {
  run rfgen "$scene" --explain
  assert_success
  assert_line "method: sweep"
  assert_line --regexp '^reason: a separable single exponential is'
  assert_line "largest error of the covariance, of variance 1: rounding"
  assert_line "share of the variance kept: 1"
  with 'autocorrelation = "squared exponential"'
  run rfgen with.toml --explain
  assert_line "method: separable"
  assert_line --regexp '^largest error of the covariance, of variance 1: [1-9][0-9.]*e-1[3-6]$'
  with 'autocorrelation = "spherical"\nlag = "elliptical"'
  run rfgen with.toml --explain
  assert_line "method: circulant"
  with 'autocorrelation = "squared exponential"\nmethod = "Karhunen-Loeve"\nvariance_kept = 0.9'
  run rfgen with.toml --explain
  assert_line "method: Karhunen-Loeve"
  assert_line --regexp '^share of the variance kept: 0.90[0-9]*$'
}

@test "every autocorrelation can be drawn, bedded and not; samples differ" {
  for name in "squared exponential" "second-order Markov" "third-order Markov" "cosine exponential" "spherical"; do
    with "autocorrelation = \"$name\""
    rfgen with.toml -n 2 -o a.h5
    assert_schema fields a.h5
    with "autocorrelation = \"$name\"\nlag = \"elliptical\"\nbedding_angle = \"20 deg\"\nnugget = 0.1"
    rfgen with.toml --first 2 -n 1 -o b.h5
    rfgen with.toml -n 2 -o c.h5
    assert_equal "$(sample c.h5 1 | cksum)" "$(sample b.h5 0 | cksum)"
    run ! cmp -s a.h5 c.h5
  done
}

@test "a method that cannot do what the scene wants exits 65 and leaves nothing" {
  with 'lag = "elliptical"\naverage = "cell"'
  run rfgen with.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial 'averages over cells want a separable correlation'
  with 'lag = "elliptical"\nmethod = "separable"'
  run rfgen with.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial 'with.toml: [field.cohesion]: method "separable" wants a separable correlation'
  sed 's/^cell = "0.1 m"/cell = "0.01 m"\nmethod = "Cholesky"/' "$scene" >dense.toml
  run rfgen dense.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial 'would take 25000 GB of memory'
  assert_not_exist fields.h5
}

# ---- marginals ----

# moments_of FILE: mean and coefficient of variation of all values.
moments_of() {
  h5_numbers "$1" /cohesion | awk '{ sum += $1; squares += $1 * $1 } END { mean = sum / NR; print mean, sqrt(squares / NR - mean * mean) / mean }'
}

@test "every marginal has the mean and spread of the scene" {
  # Ten samples at scales of 1 m; four standard errors: 5 kPa x sqrt(.0071 / 10) x 4 = 530 Pa; of the COV, 6.3 times 1.3 %.
  local marginal mean cov
  for marginal in normal gamma Weibull uniform 'beta"\nlow = "4 kPa"\nhigh = "60 kPa' 'truncated normal"\nlow = "1 kPa"\nhigh = "60 kPa'; do
    sed "s/^marginal = .*/marginal = \"$marginal\"/" "$scene" >marginal.toml
    rfgen marginal.toml -n 10 -o fields.h5
    read -r mean cov < <(moments_of fields.h5)
    assert_near "$mean" 20000 530
    assert_near "$cov" 0.25 0.02
  done
}

@test "an empirical marginal stays within its data" {
  sed 's/^marginal = .*/marginal = "empirical"\ndata = ["14 kPa", "17 kPa", "20 kPa", "28 kPa"]/; /^mean/d; /^cov/d' "$scene" >data.toml
  rfgen data.toml -n 2 -o fields.h5
  h5_numbers fields.h5 /cohesion | sort -g >values
  assert_near "$(head -n 1 values)" 14000 0
  assert_near "$(tail -n 1 values)" 28000 0
}

@test "a marginal or a correlation that cannot be exits 65 and says what can" {
  sed 's/^marginal = .*/marginal = "beta"\nlow = "18 kPa"\nhigh = "22 kPa"/' "$scene" >beta.toml
  run rfgen beta.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "[field.cohesion]: a beta distribution from 1.8e+04 to 2.2e+04 of mean 2e+04 has a standard deviation below 2000, found 5000"
  sed 's/^cov = .*/cov = 8\ncorrelation_of = "physical"/; s/"single exponential"/"cosine exponential"/' "$scene" >negative.toml
  run rfgen negative.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --regexp 'a correlation of -0\.[0-9]+ between values of this marginal distribution is infeasible; feasible are -0.01[0-9]* to 1'
  assert_not_exist fields.h5
}

# ---- several fields ----

# correlation FILE DATASET DATASET: of all their values, cell by cell.
correlation() {
  paste <(h5_numbers "$1" "/$2") <(h5_numbers "$1" "/$3") | awk '
    { a += $1; b += $2; aa += $1 * $1; bb += $2 * $2; ab += $1 * $2 }
    END { print (ab / NR - a / NR * b / NR) / sqrt((aa / NR - (a / NR) ^ 2) * (bb / NR - (b / NR) ^ 2)) }'
}

@test "fields of several parameters and soils go into one file, correlated as the scene says" {
  varied scene.toml
  rfgen scene.toml -o fields.h5
  assert_schema fields fields.h5
  assert_equal "$(h5ls fields.h5 | awk '{ print $1 }' | tr '\n' ' ')" "block cohesion cohesion.clay floored friction_angle friction_angle.clay realization residual_cohesion.clay unit_weight unit_weight.clay youngs_modulus "
  # 200 samples of 12 m x 2 m at scales of 2 m x 1 m: some 200 x 12 independent values. Four standard errors of a correlation, and .01 for
  # the bend of the lognormals; that of the clay is given for the values.
  assert_near "$(correlation fields.h5 cohesion friction_angle)" -0.5 0.08
  assert_near "$(correlation fields.h5 friction_angle unit_weight)" 0.3 0.09
  assert_near "$(correlation fields.h5 cohesion unit_weight)" 0.2 0.09
  assert_near "$(correlation fields.h5 cohesion cohesion.clay)" 0 0.09
  assert_equal "$(h5dump -a /friction_angle/unit fields.h5 | sed -n 's/.*"\(.*\)".*/\1/p' | tail -n 1)" rad
}

@test "a sample of several fields is the same in any slice; a field is the same with others beside it" {
  varied scene.toml
  rfgen scene.toml -n 5 -o many.h5
  rfgen scene.toml --first 4 -n 2 -o some.h5
  for name in cohesion friction_angle unit_weight youngs_modulus cohesion.clay residual_cohesion.clay; do
    h5_numbers many.h5 "/$name" >all
    h5_numbers some.h5 "/$name" | cmp - <(tail -n "$(($(wc -l <all) / 5 * 2))" all)
  done
  sed '/^\[field.youngs_modulus\]/,$!d; /^\[study\]/,$d' scene.toml >stiffness
  { sed '/^\[field.cohesion\]/,$d; /^\[soil.field/,/^$/d' scene.toml; cat stiffness; } | sed '/^\[field.unit_weight\]/,$d' >alone.toml
  rfgen alone.toml -n 5 -o alone.h5
  assert_equal "$(h5_numbers alone.h5 /youngs_modulus | cksum)" "$(h5_numbers many.h5 /youngs_modulus | cksum)"
}

@test "the mean follows depth" {
  varied scene.toml
  rfgen scene.toml -o fields.h5
  # Left column, lowest and highest row of 0.25 m cells below 2 m of ground: depths of 1.875 m and 0.125 m. Four standard errors.
  h5_numbers fields.h5 /cohesion.clay -s 0,0,0 -c 200,1,1 | awk '{ s += $1; q += $1 * $1 } END { print s / NR, sqrt(q / NR - (s / NR) ^ 2) }' >low
  read -r mean sd <low
  assert_near "$mean" 7875 340 # constant sd: 1200 Pa
  assert_near "$sd" 1200 260
  h5_numbers fields.h5 /youngs_modulus -s 0,0,0 -c 200,1,1 | awk '{ s += $1; q += $1 * $1 } END { print s / NR, sqrt(q / NR - (s / NR) ^ 2) }' >low
  read -r mean sd <low
  assert_near "$mean" 1937500 170000 # constant cov: 0.3
  assert_near "$sd" 581250 130000
}

@test "a correlation that no two marginals have, and stiffness that may fall to zero, exit 65" {
  sed 's/0\.6/-0.99/g' "$TOP/tests/scenes/varied.toml" >wrong.toml
  run rfgen wrong.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --regexp 'wrong.toml: \[field.cohesion.clay, residual_cohesion.clay\]: row 2, column 1 of the matrix: a correlation of -0.99 between .* feasible are -0.9'
  sed '/^\[field.youngs_modulus\]/a marginal = "normal"' "$TOP/tests/scenes/varied.toml" >wrong.toml
  run rfgen wrong.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial '[field.youngs_modulus]: values may fall to -'
  assert_not_exist fields.h5
}
