# All of pipelines/stability, with the edges of stability.
load helper

@test "all cases end as expected, edges of stability are where theory has them, and the limit of the step is safe" {
  run -0 make --no-print-directory -C "$TOP/pipelines/stability" OUT="$BATS_TEST_TMPDIR/out" BUILD="$SLIDEZONE_BUILD"
  assert_line --regexp '^USL_GIMP_4 +edge .* kept '
  assert_line --regexp '^USL_GIMP_single_4 +edge .* kept '
  assert_equal "$(grep -c '^at_rest_100_s  *as expected$' <<<"$output")" 2  # in double and in single precision
  assert_line --regexp '^MUSL_linear_1 +worst_places .* kept '
  assert_line --regexp '^[0-9]+ limits, 0 failed$'
  assert_line --regexp '^[0-9]+ cases, 0 failed$'
  refute_line --partial FAILED
  assert_file_exist "$BATS_TEST_TMPDIR/out/edge.png"
}
