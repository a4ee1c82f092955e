# Nonlocal softening makes influence and runout of the benchmark independent of the size of the cells.
load helper

# measured NAME CELL: influence and runout of regularised.toml in cells of that size.
measured() {
  sed "s/^cell = .*/cell = \"$2\"/" "$TOP/pipelines/benchmark/regularised.toml" >"$1.toml"
  mpmrun "$1.toml" -o "$1.tsv"
}

@test "I and R change by less than 5 % from cells of 0.2 m to 0.1 m" {
  cd "$BATS_TEST_TMPDIR"
  measured coarse "0.2 m"
  measured fine "0.1 m"
  for quantity in influence_m runout_m; do
    coarse=$(tsv_value $quantity <coarse.tsv)
    assert_near "$(tsv_value $quantity <fine.tsv)" "$coarse" "$(awk -v value="$coarse" 'BEGIN { print 0.05 * value }')"
  done
}
