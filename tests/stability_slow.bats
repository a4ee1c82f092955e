# All of pipelines/stability, with the edges of stability.
load helper

@test "all cases end as expected and the limit of the step is safe" {
  run -0 make --no-print-directory -C "$TOP/pipelines/stability" OUT="$BATS_TEST_TMPDIR/out" BUILD="$SLIDEZONE_BUILD"
  assert_line --regexp '^edge_4_points +block_nu_0.49 .* kept '
  assert_line --regexp '^[0-9]+ cases, 0 failed$'
  refute_line --partial FAILED
  assert_file_exist "$BATS_TEST_TMPDIR/out/edge.png"
}
