# pipelines/stability in its quick form, and the probe that runs its cases.
load helper

probe() { "$TOP/pipelines/stability/probe" "$@"; }

# cases CHANGES EXPECTED: one case of the slope of the tests
cases() {
  cp "$TOP/tests/scenes/tiny.toml" .
  printf 'case\twhen\tscene\tchanges\texpected\twhy\nit\tquick\ttiny\t%s\t%s\ta reason\n' "$@" >cases.tsv
}

setup() { cd "$BATS_TEST_TMPDIR"; }

@test "stiff and extreme cases end as expected" {
  run -0 make --no-print-directory -C "$TOP/pipelines/stability" quick OUT="$BATS_TEST_TMPDIR/out" BUILD="$SLIDEZONE_BUILD"
  assert_equal "$(grep -c '^stiff_100_mpa  *as expected$' <<<"$output")" 2  # in double and in single precision
  assert_line --regexp '^[0-9]+ cases, 0 failed$'
  assert_line --regexp '^USL_GIMP_1 +edge .* kept '
  assert_line --regexp '^[0-9]+ limits, 0 failed$'
  refute_line --partial FAILED
}

@test "a case that ends otherwise fails" {
  cases '' 'status slid ; runout_m > 0.1'
  run -0 probe cases.tsv quick
  for expected in 'status stable' 'runout_m < 0.1' 'runout_m = 100 +- 5 %' "refused 'height'"; do
    cases '' "$expected"
    run -1 probe cases.tsv quick
    assert_line --regexp '^it +FAILED$'
  done
}

@test "changes reach keys that are there, new tables and second soils; a refusal is held against its words" {
  cases 'slope.height = "0 m"' "refused 'height' wants above 0 m"
  run -0 probe cases.tsv quick
  cases 'slope.height =' "refused no key 'height' in [slope]"
  run -0 probe cases.tsv quick
  cases 'study.seed = -1' "refused 'seed' wants a whole number"
  run -0 probe cases.tsv quick
  cases 'soil2.name = "clay"' "refused in [soil]"
  run -0 probe cases.tsv quick
}

@test "changes to all cases come before a case's own" {
  cases '' "refused 'height' wants above 0 m"
  run -0 probe cases.tsv quick 'slope.height = "0 m"'
  cases 'slope.height = "-1 m"' "refused found \"-1 m\""
  run -0 probe cases.tsv quick 'slope.height = "0 m"'
}
