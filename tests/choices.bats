# pipelines/choices: every variant of the benchmark is a scene that differs from it and that the reader takes.
load helper

@test "every variant is a good scene, and no two are the same" {
  cd "$BATS_TEST_TMPDIR"
  for script in "$TOP"/pipelines/choices/variants/*.sed; do
    name=$(basename "$script" .sed)
    sed -f "$script" "$TOP/pipelines/benchmark/scene.toml" >"$name.toml"
    run "$SLIDEZONE_BUILD/tests/read_scene" "$name.toml"
    assert_success
  done
  assert_equal "$(cksum -- *.toml | awk '{ print $1 }' | sort | uniq -d)" ""
}
