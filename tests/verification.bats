# pipelines/verification in its quick form, and the judge of its results.
load helper

judge() { "$TOP/pipelines/judge" "$@"; }

# limits MEASURE LIMIT; results EXACT COMPUTED
limits() { printf 'case\tquantity\tmeasure\tlimit\twhen\twhy\nbar\tperiod_s\t%s\t%s\tquick\ta reason\n' "$@" >limits.tsv; }
results() { printf 'case\tquantity\tsize\texact\tcomputed\nbar\tperiod_s\tnan\t%s\t%s\n' "$@" >results.tsv; }

setup() { cd "$BATS_TEST_TMPDIR"; }

@test "the quick cases keep their limits" {
  run -0 make --no-print-directory -C "$TOP/pipelines/verification" quick OUT="$BATS_TEST_TMPDIR/out" BUILD="$SLIDEZONE_BUILD"
  assert_line --regexp '^elastic_bar +order of period_s .* kept '
  assert_line --regexp '^[0-9]+ limits, 0 failed$'
  refute_line --partial FAILED
}

@test "a limit that is not kept fails, a result that is no number too" {
  limits relative 0.01
  results 2 2.01
  run -0 judge limits.tsv quick results.tsv
  for computed in 2.03 1.97 nan inf; do
    results 2 "$computed"
    run -1 judge limits.tsv quick results.tsv
    assert_line --partial FAILED
  done
}

@test "an order is measured over the sizes, and wants three of them" {
  limits order 1.9
  printf 'case\tquantity\tsize\texact\tcomputed\n' >results.tsv
  printf 'bar\tperiod_s\t%s\t1\t%s\n' 4 1.16 2 1.04 >>results.tsv
  run -1 judge limits.tsv quick results.tsv
  assert_output --partial "wants at least 3 sizes, found 2"
  printf 'bar\tperiod_s\t%s\t1\t%s\n' 1 1.01 >>results.tsv
  run -0 judge limits.tsv quick results.tsv
  assert_line --partial "2.00"
  limits order 2.1
  run -1 judge limits.tsv quick results.tsv
}

@test "a limit for each row holds for the worst of them" {
  limits each 0.02
  printf 'case\tquantity\tsize\texact\tcomputed\n' >results.tsv
  printf 'bar\tperiod_s\t%s\t%s\t%s\n' 0.33 2 2.03 0 1 1.01 >>results.tsv
  run -0 judge limits.tsv quick results.tsv
  assert_line --partial "1.5 %"
  printf 'bar\tperiod_s\t0.49\t3\t3.1\n' >>results.tsv
  run -1 judge limits.tsv quick results.tsv
  sed -i 's/3.1$/nan/' results.tsv
  run -1 judge limits.tsv quick results.tsv
}

@test "a case without result and a result without limit are errors" {
  limits absolute 1
  results 2 2
  sed -i 's/bar/rod/' results.tsv
  run -1 judge limits.tsv quick results.tsv
  assert_output --partial "('bar', 'period_s')"
  assert_output --partial "('rod', 'period_s')"
}
