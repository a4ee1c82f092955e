# All of pipelines/verification, with its plots.
load helper

@test "all cases keep their limits, and the orders are drawn" {
  run -0 make --no-print-directory -C "$TOP/pipelines/verification" OUT="$BATS_TEST_TMPDIR/out" BUILD="$SLIDEZONE_BUILD"
  assert_line --regexp '^vertical_cut +number_2_none .* kept '
  assert_line --regexp '^[0-9]+ limits, 0 failed$'
  assert_file_exist "$BATS_TEST_TMPDIR/out/convergence.png"
  assert_file_exist "$BATS_TEST_TMPDIR/out/convergence.svg"
}
