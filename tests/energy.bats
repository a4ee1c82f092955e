# The energy balance of every shipped scene, with one strength everywhere: closed to 1 % of the work of gravity.
load helper

# Scenes that take longer than two seconds are in energy_slow.bats.
slow='benchmark/(scene|regularised)\.toml'

setup() { cd "$BATS_TEST_TMPDIR"; }

@test "every shipped scene closes its energy balance to 1 %" {
  find "$TOP"/pipelines -name '*.toml' -not -path '*/out/*' | grep -vE "$slow" | sort >scenes
  assert [ "$(wc -l <scenes)" -ge 10 ]
  while read -r scene; do
    mpmrun "$scene" --quiet -o row.tsv
    echo "$scene: $(tsv_value status <row.tsv), $(tsv_value energy_error <row.tsv)"
    assert_near "$(tsv_value energy_error <row.tsv)" 0 0.01
  done <scenes
}
