# Rows made up for the tests of mcstats and zoning.

# row REALIZATION STATUS INFLUENCE RUNOUT: one line of a table of rows.
row() { printf '%s\t%s\t%s\t%s\t0\t0\t0\t10\t100\t0.001\t0\n' "$1" "$2" "$3" "$4"; }

row_header() {
  printf '# schema: slidezone-row 1\n# tool: mpmrun 0.1.0\n'
  printf '%s\n' 'realization status influence_m runout_m influence_1m_m runout_max_m displaced_area_m2 rest_time_s steps energy_error floored' |
    tr ' ' '\t'
}

# pairs COUNT: antithetic pairs 1 ... COUNT of rows with their design; the reaches of a pair are opposed about 10 and 20 but for its number.
pairs() {
  row_header | sed '/^realization/s/$/\tdesign\tblock/'
  awk -v count="$1" 'BEGIN { OFS = "\t"
    for (k = 1; k <= 2 * count; ++k) { pair = int((k + 1) / 2); d = (k % 2 ? 1 : -1) * (pair % 7) + pair / 1000
      print k, "slid", 10 + d, 20 + d, 0, 0, 0, 10, 100, 0.001, 0, "antithetic", pair } }'
}

# ladder COUNT: realizations 1 ... COUNT that slid, influence k / 100 and runout 10 + k / 100 for the k-th.
ladder() {
  row_header
  local k
  for ((k = 1; k <= $1; ++k)); do
    printf '%d\tslid\t%d.%02d\t%d.%02d\t0\t0\t0\t10\t100\t0.001\t0\n' $k $((k / 100)) $((k % 100)) $((10 + k / 100)) $((k % 100))
  done
}

# What every tool that reads rows does with a command line and a table that are wrong: check_contract TOOL.
check_contract() {
  local tool=$1
  check_help "$tool"
  run --separate-stderr "$tool" --no-such-option
  assert_failure 64
  assert_equal "$output" ""
  run --separate-stderr "$tool" "$BATS_TEST_TMPDIR/absent.tsv"
  assert_failure 66
  assert_equal "$output" ""
}
