# The rest rule against running the full time: 200 random slopes of the demo. Takes minutes.
load helper

# rows SCENE: the rows of samples 1 to 200.
rows() {
  local k
  for k in {1..200}; do mpmrun -q "$1" --points points.h5 --sample "$k"; done
}

@test "the rest rule misses no late block in 200 random slopes, and saves time" {
  cd "$BATS_TEST_TMPDIR"
  sed 's/^step_fraction = .*/&\n[time.rest]/' "$TOP/pipelines/demo/scene.toml" >resting.toml
  grep -q '^\[time.rest\]' resting.toml
  rfgen -q resting.toml -n 200 -o fields.h5
  rfmap -q resting.toml fields.h5 -o points.h5
  cp "$TOP/pipelines/demo/scene.toml" full.toml
  rows full.toml >full.tsv 3>&- &
  rows resting.toml >resting.tsv
  wait
  # A column of the surface is 0.4 m: one that hangs near the threshold of 0.5 m swings about it, and I with it, also at the end
  # of full runs. A block is more than a column.
  run awk -F'\t' '
    /^[0-9]/ && FNR == NR { influence[$1] = $3; steps[$1] = $9; full += $9 }
    /^[0-9]/ && FNR != NR { n++; used += $9; d = $3 - influence[$1]; if (d < 0) d = -d; if (d > 0.41) { missed++; print "missed in " $1 ": " d } }
    END { printf "%d runs, %d missed, %.1f %% saved\n", n, missed, 100 * (1 - used / full); exit !(n == 200 && missed == 0 && used < 0.95 * full) }
  ' full.tsv resting.tsv
  echo "$output"
  assert_success
}
