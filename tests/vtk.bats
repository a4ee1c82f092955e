# State files as VTK reads them, against the table of the same run. Slow: python3-vtk9 brings half a desktop along.
load helper

@test "VTK reads every point of a state, where the table has it, with the same plastic strain" {
  cd "$BATS_TEST_TMPDIR"
  mpmrun "$TOP/tests/scenes/tiny.toml" --state state.hdf --table table.tsv >row.tsv
  /usr/bin/python3 "$TOP/tests/read_state.py" state.hdf >seen.tsv
  awk -F '\t' '$1 == "file" || $8 == "plastic_strain"' seen.tsv >strain.tsv
  # Extremes of a column of the table.
  extreme() { grep -v '^#' table.tsv | cut -f "$(head_column "$1")" | tail -n +2 | sort -g | "$2" -n 1; }
  head_column() { grep -v '^#' table.tsv | head -n 1 | tr '\t' '\n' | grep -nx "$1" | cut -d : -f 1; }
  local points
  points=$(grep -vc '^[#x]' table.tsv)
  assert_equal "$(tsv_value points <strain.tsv)" "$points"
  assert_equal "$(tsv_value cells <strain.tsv)" "$points"
  # The same doubles on either side, printed with 15 digits or more.
  assert_near "$(tsv_value x_low <strain.tsv)" "$(extreme x_m head)" 1e-12
  assert_near "$(tsv_value x_high <strain.tsv)" "$(extreme x_m tail)" 1e-12
  assert_near "$(tsv_value y_low <strain.tsv)" "$(extreme y_m head)" 1e-12
  assert_near "$(tsv_value y_high <strain.tsv)" "$(extreme y_m tail)" 1e-12
  assert_near "$(tsv_value low <strain.tsv)" "$(extreme plastic_strain head)" 1e-12
  assert_near "$(tsv_value high <strain.tsv)" "$(extreme plastic_strain tail)" 1e-12
}

@test "VTK reads every frame that the index of an animation names" {
  cd "$BATS_TEST_TMPDIR"
  mpmrun "$TOP/tests/scenes/tiny.toml" --frames frames --every "1 s" >row.tsv
  local names
  names=$(/usr/bin/python3 -c 'import json; print(*[f["name"] for f in json.load(open("frames/frames.hdf.series"))["files"]])')
  assert_equal "$(wc -w <<<"$names")" 3
  cd frames
  # shellcheck disable=SC2086
  /usr/bin/python3 "$TOP/tests/read_state.py" $names >seen.tsv
  assert_equal "$(cut -f 1 seen.tsv | tail -n +2 | sort -u | wc -l)" 3
}
