# What README says that `make demo` prints, against what it prints. Slow: the benchmark at full resolution.
load helper

@test "README shows what the demo prints" {
  cd "$BATS_TEST_TMPDIR"
  awk '/^Failing the benchmark/ { is_in = 1 } /^```$/ { is_in = 0 } is_in' "$TOP/README.md" >shown
  study() { make --no-print-directory -C "$TOP/pipelines/$1" TOOLS="$SLIDEZONE_BIN" OUT="$BATS_TEST_TMPDIR/$1" 2>/dev/null; }
  {
    echo "Failing the benchmark slope once, at full resolution"
    study benchmark
    printf '\n%s\n' "Failing a small one 24 times, with random strength"
    study demo
  } >printed
  # Only the folder of the pictures differs.
  run diff <(grep -v '\.png' shown) <(grep -v '\.png' printed)
  assert_success
}
