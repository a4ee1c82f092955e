# rfgen: samples of a random field. Numbers are read from the HDF5 files by h5dump.
load helper

setup() {
  cd "$BATS_TEST_TMPDIR"
  scene=$TOP/pipelines/demo/scene.toml
}

# h5_numbers FILE DATASET [h5dump options]: the numbers, one per line.
h5_numbers() { h5dump -A 0 -y -w 1 -m %.17g -d "$2" "${@:3}" "$1" | sed -n 's/^ *\(-\{0,1\}[0-9][-+.0-9e]*\),\{0,1\}$/\1/p'; }

# sample FILE INDEX: the values of one sample.
sample() { h5_numbers "$1" /cohesion -s "$2,0,0" -c 1,50,250; }

# ---- contract ----

@test "--help and --version go to stdout" {
  run --separate-stderr rfgen --help
  assert_success
  assert_output --partial "Example: rfgen"
  assert_equal "$stderr" ""
  run --separate-stderr rfgen --version
  assert_success
  assert_output --regexp '^rfgen [0-9]'
  assert_equal "$stderr" ""
}

@test "wrong command lines exit 64" {
  run rfgen
  assert_failure 64
  for option in --sed=1 --count=0 --count=-1 --first=0 --first=010 --seed=nan --seed=-3; do
    run rfgen "$scene" "$option"
    assert_failure 64
    assert_output --regexp '^rfgen: '
  done
  run rfgen "$scene" --first 4294967295 -n 2 -o fields.h5
  assert_failure 64
  assert_output --partial "numbered up to 4294967295"
}

@test "a missing scene exits 66" {
  run rfgen missing.toml
  assert_failure 66
  assert_output --partial "rfgen: missing.toml: "
}

@test "a broken scene exits 65, names file, line and column, and leaves nothing" {
  sed 's/^cov = .*/cov = -1/' "$scene" >broken.toml
  run rfgen broken.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --regexp "^rfgen: broken.toml:$(grep -n '^cov' broken.toml | cut -d: -f1):7: 'cov' wants"
  assert_not_exist fields.h5
}

@test "a scene without a random field exits 65" {
  run rfgen "$TOP/pipelines/benchmark/scene.toml" -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "[field]"
}

@test "an output that cannot be created exits 73; a full disk 74; nothing is left" {
  run rfgen "$scene" -n 1 -o missing/fields.h5
  assert_failure 73
  run rfgen "$scene" -n 1 -o /dev/full
  assert_failure 74
  run bash -c "rfgen '$scene' -n 1 >/dev/full"
  assert_failure 74
  assert_equal "$(ls)" ""
}

@test "a terminal is refused with 64" {
  run script --quiet --return --command "rfgen '$scene' -n 1" /dev/null
  assert_failure 64
  assert_output --partial "stdout is a terminal"
}

@test "equal inputs give equal bytes, through a pipe or a file" {
  rfgen "$scene" -n 2 -o a.h5
  rfgen "$scene" -n 2 -o b.h5
  rfgen - -n 2 <"$scene" >c.h5
  cmp a.h5 b.h5
  cmp a.h5 c.h5
}

@test "the file obeys its description" {
  rfgen "$scene" -n 2 -o a.h5
  assert_schema fields a.h5
}

# ---- methods ----

# with LINES: the demo's scene with these lines in its field, and without its autocorrelation.
with() { sed "s/^autocorrelation = .*/$1/" "$scene" >with.toml; }

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

# ---- measurements ----

@test "samples honour the measurements that the scene names" {
  mkdir scene
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/' "$scene" >scene/scene.toml
  printf '%s\t%s\t%s\t%s\n' x_m depth_m value_kPa error_kPa 5.05 0.55 31.5 0 5.05 2.05 12.25 0 22.05 1 18 2 >scene/borings.tsv
  assert_schema measurements scene/borings.tsv
  rfgen scene/scene.toml -n 3 -o fields.h5
  assert_schema fields fields.h5
  local index
  for index in 0 1 2; do # cells: x 5.05 m is column 50; 5 m - 0.55 m = 4.45 m is row 44, 2.95 m row 29
    assert_near "$(h5_numbers fields.h5 /cohesion -s "$index,44,50" -c 1,1,1)" 31500 1e-4
    assert_near "$(h5_numbers fields.h5 /cohesion -s "$index,29,50" -c 1,1,1)" 12250 1e-4
  done
  # The third has an error of 2 kPa: there the spread falls from 5 kPa to some sqrt(1/(1/25 + 1/4)) = 1.9 kPa, and the mean goes to
  # some 20 - 2 x 25/29 = 18.3 kPa. Four standard errors, and 0.2 kPa for the lognormal's bend. 2.95 m - 1 m is row 19.
  rfgen scene/scene.toml -n 100 -o many.h5
  h5_numbers many.h5 /cohesion -s 0,19,220 -c 100,1,1 |
    awk '{ s += $1; q += $1 * $1 } END { print s / NR, sqrt(q / NR - (s / NR) ^ 2) }' >moments
  read -r mean sd <moments
  assert_near "$mean" 18300 1000
  assert_between "$sd" 1200 2600
}

@test "measurements that cannot be met exit 65, a missing table 66" {
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/' "$scene" >scene.toml
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 66
  assert_output --partial "borings.tsv: cannot be opened"
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 5.05 0.55 31.5 5.07 0.57 30 >borings.tsv
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "borings.tsv:3: found 3e+04, but borings.tsv:2 gives the same cell 3.15e+04"
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 5.05 6 31.5 >borings.tsv
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "borings.tsv:2: point 1 at (5.05 m, -1 m) lies outside the mesh"
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 5.05 1 -31.5 >borings.tsv
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "borings.tsv:2: found -3.15e+04, which no sample can honour: values of this field are held between 4000 and inf"
  assert_not_exist fields.h5
}

# refused_borings MESSAGE TABLE: of scene.toml, with that text in its table of measurements.
refused_borings() {
  printf "$2" >borings.tsv
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "$1"
  assert_not_exist fields.h5
}

@test "tables of measurements that would be misread are refused" {
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/' "$scene" >scene.toml
  refused_borings "borings.tsv:1: found the column 'error', expected 'error_kPa'" 'x_m\tdepth_m\tvalue_kPa\terror\n5\t1\t25\t2\n'
  refused_borings "borings.tsv:1: found the column 'error_Pa', expected 'error_kPa'" 'x_m\tdepth_m\tvalue_kPa\terror_Pa\n5\t1\t25\t2\n'
  refused_borings "borings.tsv: found no measurement in the soils" 'x_m\tdepth_m\tvalue_kPa\n'
  refused_borings "borings.tsv:2: found 1.2e+05, a value that the marginal distribution has less than once" 'x_m\tdepth_m\tvalue_kPa\n5\t1\t120\n'
  sed -i 's/^cov = .*/cov = 0.5/' scene.toml
  refused_borings "borings.tsv:2: found 3500, which no sample can honour: values of this field are held between 4000 and inf" 'x_m\tdepth_m\tvalue_kPa\n5\t1\t3.5\n'
  refused_borings "borings.tsv:2: column 'value_kPa': found 'nan', expected a finite number" 'x_m\tdepth_m\tvalue_kPa\n5\t1\tnan\n'
  refute_output --partial "borings.tsv:2: borings.tsv:2"
}

@test "measurements may end their lines as Windows does" {
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/' "$scene" >scene.toml
  printf 'x_m\tdepth_m\tvalue_kPa\r\n5.05\t0.55\t31.5\r\n' >borings.tsv
  rfgen scene.toml -n 1 -o fields.h5
  assert_near "$(h5_numbers fields.h5 /cohesion -s 0,44,50 -c 1,1,1)" 31500 1e-4
}

@test "a field honours the measurements in its own soils, and says how many" {
  # The clay lies below 1 m: of three depths one is in it, two in the fill above. Cells of 0.25 m.
  sed 's/^\[field.cohesion\]\|^\[soil.field.cohesion\]/&\nmeasurements = "boring.tsv"/' "$TOP/tests/scenes/varied.toml" >scene.toml
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 1.1 0.1 4 1.1 0.6 3.5 1.1 1.4 6 >boring.tsv
  run rfgen scene.toml --explain
  assert_line "measurements honoured: 2"
  assert_line "measurements honoured: 1"
}

# ---- samples ----

@test "count and seed come from [study] unless given" {
  rfgen "$scene" -o a.h5
  rfgen "$scene" -n 24 --seed 1 --first 1 -o b.h5
  cmp a.h5 b.h5
  rfgen "$scene" -n 24 --seed 2 -o c.h5
  run ! cmp -s a.h5 c.h5
}

@test "a sample is the same alone, among others, and at another first" {
  rfgen "$scene" -n 5 -o many.h5
  rfgen "$scene" --first 4 -n 1 -o one.h5
  rfgen "$scene" --first 3 -n 3 -o some.h5
  assert_equal "$(h5_numbers one.h5 /realization)" 4
  assert_equal "$(h5_numbers some.h5 /realization | tr '\n' ' ')" "3 4 5 "
  sample many.h5 3 >among
  assert_equal "$(wc -l <among)" 12500
  sample one.h5 0 | cmp - among
  sample some.h5 1 | cmp - among
  sample some.h5 2 >other
  run ! cmp -s other among
}

@test "a sample keeps its bits from version to version" {
  rfgen "$scene" --first 7 -n 1 -o seventh.h5
  assert_equal "$(sample seventh.h5 0 | md5sum | cut -d' ' -f1)" 2e48d2c966d59832b0231563f00dd765 # as of version 0.1.0
}

@test "values have the mean, the spread and the floor of the scene" {
  # Four standard errors each, as tests/unit/field.cpp has them for 400 samples; here are 40.
  sed 's/^cov = .*/cov = 0.5/' "$scene" >wide.toml
  rfgen wide.toml -n 40 -o wide.h5
  h5_numbers wide.h5 /cohesion | awk '
    { sum += $1; squares += $1 * $1; floored += $1 == 4000; if (NR == 1 || $1 < least) least = $1 }
    END { mean = sum / NR; print mean, sqrt(squares / NR - mean * mean) / mean, least, floored }' >moments
  read -r mean cov least floored <moments
  assert_near "$mean" 20000 532
  assert_near "$cov" 0.5 0.013
  assert_near "$least" 4000 0
  assert_between "$floored" 217 543 # 500,000 x 7.6e-4 = 380
  assert_equal "$floored" "$(h5_numbers wide.h5 /floored | awk '{ sum += $1 } END { print sum }')"
}

@test "an interrupted run leaves nothing" {
  rfgen "$scene" -n 100000 -o fields.h5 &
  local pid=$! status=0
  until [[ -n $(find . -size +100k) ]]; do :; done
  kill -TERM $pid
  wait $pid || status=$?
  assert_equal $status 143
  assert_equal "$(ls)" ""
}

@test "memory does not grow with the number of samples" {
  run bash -c "ulimit -v 200000; rfgen '$scene' -n 5000 >/dev/null" # 500 MB of numbers, 200 MB of address space
  assert_success
}

# ---- check ----

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

# ---- designs ----

@test "samples of a design are the same in any slice, also one that begins inside a block" {
  local design
  for design in antithetic "Latin hypercube"; do
    sed "s/^realizations = .*/&\ndesign = \"$design\"/" "$scene" >design.toml
    rfgen design.toml -n 20 -o many.h5
    assert_schema fields many.h5
    rfgen design.toml --first 18 -n 1 -o one.h5
    sample one.h5 0 >alone
    sample many.h5 17 | cmp - alone
    run h5dump -a /design many.h5
    assert_output --partial "\"$design\""
  done
  assert_equal "$(h5_numbers many.h5 /block | uniq -c | tr -s ' ' | tr '\n' ';')" " 16 1; 4 2;"
  run ! cmp -s many.h5 <(rfgen "$scene" -n 20)
}

@test "the second of an antithetic pair is low where the first is high" {
  sed 's/^realizations = .*/&\ndesign = "antithetic"/' "$scene" >design.toml
  rfgen design.toml -n 4 -o pairs.h5
  assert_equal "$(h5_numbers pairs.h5 /block | tr '\n' ' ')" "1 1 2 2 "
  # The product of the values of a pair is the square of the lognormal's median, 20 kPa / sqrt(1 + cov^2).
  run awk 'NR == FNR { first[NR] = $1; next } { p = first[FNR] * $1 / (20000 * 20000 / 1.0625) - 1; if (p > 1e-12 || p < -1e-12) ++wrong } END { print FNR, wrong + 0 }' \
    <(sample pairs.h5 2) <(sample pairs.h5 3)
  assert_output "12500 0"
}

# ---- several fields ----

# varied FILE: the scene of tests/scenes/varied.toml with fine cells, so that few samples tell.
varied() { sed 's/^realizations = 4/realizations = 200/' "$TOP/tests/scenes/varied.toml" >"$1"; }

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
  sed 's/^\[\[1, 0.6\], \[0.6, 1\]\]/x/; s/0\.6/-0.99/g' "$TOP/tests/scenes/varied.toml" >wrong.toml
  run rfgen wrong.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --regexp 'wrong.toml: \[field.cohesion.clay, residual_cohesion.clay\]: row 2, column 1 of the matrix: a correlation of -0.99 between .* feasible are -0.9'
  sed '/^\[field.youngs_modulus\]/a marginal = "normal"' "$TOP/tests/scenes/varied.toml" >wrong.toml
  run rfgen wrong.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial '[field.youngs_modulus]: values may fall to -'
  assert_not_exist fields.h5
}

@test "measurements of any parameter are read in its unit" {
  sed '/^\[field.friction_angle\]/a measurements = "angles.tsv"' "$TOP/tests/scenes/varied.toml" >scene.toml
  printf '%s\t%s\t%s\t%s\n' x_m depth_m value_deg error_deg 1.1 0.6 33 0 >angles.tsv
  assert_schema measurements angles.tsv
  rfgen scene.toml -n 2 -o fields.h5
  assert_schema fields fields.h5
  assert_near "$(h5_numbers fields.h5 /friction_angle -s 1,5,4 -c 1,1,1)" 0.575958653158 1e-9
}

@test "a perfectly plastic soil carries a field of cohesion" {
  sed '/^residual_cohesion/d; /^softening/d; s/^cov = .*/cov = 0.5/' "$scene" >plastic.toml
  rfgen plastic.toml -n 3 -o fields.h5
  assert_equal "$(h5_numbers fields.h5 /floored | tr '\n' ' ')" "0 0 0 "
  assert_between "$(h5_numbers fields.h5 /cohesion | sort -g | head -n 1)" 1000 4000
}

@test "with several soils the floor is the least of their residual strengths" {
  cat >layers.toml <<END
$(sed '/^\[\[soil\]\]/,/^$/d' "$scene")

[[soil]]
name = "crust"
unit_weight = "18 kN/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.33
cohesion = "30 kPa"
residual_cohesion = "15 kPa"
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
  rfgen layers.toml -n 1 -o fields.h5
  assert_near "$(h5_numbers fields.h5 /cohesion | sort -g | head -n 1)" 12000 0
}
