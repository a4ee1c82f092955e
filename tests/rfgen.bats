# rfgen: command line and files, the samples of a study and their designs.
load helper
load fields

# ---- contract ----

@test "--help and --version go to stdout" { check_help rfgen; }

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

# ---- floors ----

@test "a perfectly plastic soil carries a field of cohesion" {
  sed '/^residual_cohesion/d; /^softening/d; s/^cov = .*/cov = 0.5/' "$scene" >plastic.toml
  rfgen plastic.toml -n 3 -o fields.h5
  assert_equal "$(h5_numbers fields.h5 /floored | tr '\n' ' ')" "0 0 0 "
  assert_between "$(h5_numbers fields.h5 /cohesion | sort -g | head -n 1)" 1000 4000
}

@test "with several soils the floor is the least of their residual strengths" {
  two_soils >layers.toml
  rfgen layers.toml -n 1 -o fields.h5
  assert_near "$(h5_numbers fields.h5 /cohesion | sort -g | head -n 1)" 12000 0
}
