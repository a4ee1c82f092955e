# Studies: pipelines/study.mk with the real tools on a tiny scene, each tool behind a stand-in that notes its calls.
load helper

setup() {
  study=$BATS_TEST_TMPDIR/study
  tools=$BATS_TEST_TMPDIR/tools
  export calls=$BATS_TEST_TMPDIR/calls
  mkdir "$study" "$tools"
  cp "$TOP/tests/scenes/tiny.toml" "$study/scene.toml"
  printf 'name\tside\tdistance_m\nhut\ttoe\t1\nmast\tcrest\t3\n' >"$study/structures.tsv"
  printf '%s\n' 'SCENE := scene.toml' "include $TOP/pipelines/study.mk" >"$study/Makefile"
  # A stand-in notes its call, does what the file before.TOOL says if there is one, and becomes the tool.
  export real=$SLIDEZONE_BIN hooks=$BATS_TEST_TMPDIR
  local tool
  for tool in rfgen rfmap mpmrun mcstats zoning; do
    cat >"$tools/$tool" <<'END'
#!/usr/bin/env bash
set -eu
tool=$(basename "$0")
echo "$tool $*" >>"$calls"
if [[ -e $hooks/before.$tool ]]; then . "$hooks/before.$tool"; fi
exec "$real/$tool" "$@"
END
    chmod +x "$tools/$tool"
  done
  forget_calls
}

# before TOOL <<<COMMANDS: what its stand-in does first.
before() { cat >"$hooks/before.$1"; }

forget_calls() { : >"$calls"; }

run_study() { run make --no-print-directory -C "$study" TOOLS="$tools" "$@"; }

# samples_run: the realizations that mpmrun was called for, in order, on one line.
samples_run() { sed -n 's/^mpmrun .*--sample \([0-9]*\) .*-o out.rows.*/\1/p' "$calls" | sort -n | xargs; }

# sums OUT: checksums of all tables and HDF5 files of a study.
sums() { (cd "$1" && find . -name '*.tsv' -o -name '*.h5' -o -name '*.hdf' | sort | xargs md5sum); }

@test "a study leaves rows, tables that obey their schemas, pictures and a summary" {
  run_study
  assert_success
  assert_output --partial "Tiny: 2 m slope"
  assert_equal "$(samples_run)" "1 2 3 4"
  local table
  for table in rows/000003.tsv:row rows.tsv:row statistics.tsv:statistics classes.tsv:classes curve.tsv:curve structures.tsv:structures \
    in_situ.h5:stage trace.tsv:trace histogram.tsv:histogram densities.tsv:densities \
    shown/row.tsv:row shown/points.tsv:table shown/surface.tsv:profile shown/state.hdf:state fields/000001.h5:fields points/000001.h5:points; do
    assert_schema "${table#*:}" "$study/out/${table%:*}"
  done
  assert_equal "$(grep -c '^[0-9]' "$study/out/rows.tsv")" 5
  local picture
  for picture in slope exceedance zones trace distribution; do
    assert_equal "$(head -c 8 "$study/out/$picture.png" | od -An -tx1 | xargs)" "89 50 4e 47 0d 0a 1a 0a"
    run grep -c '</svg>' "$study/out/$picture.svg"
    assert_output 1
  done
}

@test "the lists of structures that stand beside shipped scenes obey their schema" {
  local list
  for list in "$TOP"/pipelines/*/structures.tsv; do
    assert_schema structures-input "$list"
  done
}

@test "a study says how many realizations are done, all of them at the end, and nothing where none was to do" {
  run_study rows N=3
  assert_success
  assert_line "realizations: 3 of 3 done"
  assert_not_exist "$study/out/progress"
  run_study tables N=3
  refute_output --partial "realizations:"
  : >"$study/out/progress"  # as another job finds it that is just being written
  run_study tables N=4
  assert_success
  assert_line "realizations: 4 of 4 done"
}

@test "a greater N runs only the new realizations, a smaller one none" {
  run_study tables N=3
  assert_success
  forget_calls
  run_study tables N=6
  assert_success
  assert_equal "$(samples_run)" "4 5 6"
  run ! grep -E '^(rfgen|rfmap)' "$calls"
  forget_calls
  run_study tables N=2
  assert_success
  assert_equal "$(samples_run)" ""
  assert_equal "$(grep -c '^[0-9]' "$study/out/rows.tsv")" 3
}

@test "what was done is not done again; a touch of the scene changes nothing, another text everything" {
  run_study tables N=2
  assert_success
  forget_calls
  touch "$study/scene.toml"
  run_study tables N=2
  assert_success
  assert_equal "$(<"$calls")" ""
  sed -i 's/^seed = 1/seed = 2/' "$study/scene.toml"
  run_study tables N=2
  assert_success
  assert_equal "$(samples_run)" "1 2"
  run grep -c '^rfgen' "$calls"
  assert_output 1
}

@test "other measurements make everything anew, a touch of their table nothing" {
  sed -i '/^\[field.cohesion\]/a measurements = "borings.tsv"' "$study/scene.toml"
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 2.1 0.6 6 >"$study/borings.tsv"
  run_study rows N=2
  assert_success
  forget_calls
  touch "$study/borings.tsv"
  run_study rows N=2
  assert_success
  assert_equal "$(<"$calls")" ""
  sed -i 's/6$/4/' "$study/borings.tsv"
  run_study rows N=2
  assert_success
  assert_equal "$(samples_run)" "1 2"
  rm "$study/borings.tsv"
  run_study rows N=2
  assert_failure
  assert_output --partial "borings.tsv"
}

@test "a study of one soil's field is random, and rows carry its design" {
  sed -i 's/^\[field.cohesion\]/[soil.field.cohesion]/; s/^seed = 1/&\ndesign = "antithetic"/' "$study/scene.toml"
  awk '/^\[soil.field/ { hold = 1 } /^\[study\]/ { hold = 0 } hold { field = field $0 "\n"; next } { rest = rest $0 "\n" }
    END { sub(/\n\[base\]/, "\n" field "[base]", rest); printf "%s", rest }' "$study/scene.toml" >"$study/own.toml"
  run_study rows N=4 SCENE=own.toml
  assert_success
  assert_equal "$(tail -qn 1 "$study"/out/rows/00000[1-4].tsv | cut -f 12,13 | tr '\t\n' ': ')" "antithetic:1 antithetic:1 antithetic:2 antithetic:2 "
}

@test "another build of mpmrun runs everything anew, an equal one nothing" {
  run_study tables N=2
  assert_success
  forget_calls
  cp "$tools/mpmrun" "$tools/copy" && mv "$tools/copy" "$tools/mpmrun"
  run_study tables N=2
  assert_success
  assert_equal "$(<"$calls")" ""
  echo '# another build' >>"$tools/mpmrun"
  run_study tables N=2
  assert_success
  assert_equal "$(samples_run)" "1 2"
}

@test "a study has the same bytes under any -j" {
  run_study tables N=6 --jobs=1
  assert_success
  mv "$study/out" "$study/one"
  run_study tables N=6 --jobs=3
  assert_success
  assert_equal "$(sums "$study/out")" "$(sums "$study/one")"
}

@test "rows start from the in-situ stage, which is made once, and are those of runs from the beginning" {
  sed -i 's/^protocol = .*/protocol = "ramp"\nramp_time = "10 s"/; s/^end = .*/end = "10 s"/' "$study/scene.toml"
  run_study rows N=3
  assert_success
  assert_equal "$(grep -c '^mpmrun .*--make-in-situ' "$calls")" 1
  assert_equal "$(grep -c '^mpmrun .*--in-situ out/in_situ.h5' "$calls")" 3
  "$real/mpmrun" "$study/scene.toml" --points "$study/out/points/000001.h5" --sample 3 | cmp - "$study/out/rows/000003.tsv"
  rm "$study/out/in_situ.h5"
  forget_calls
  run_study rows N=3
  assert_success
  assert_equal "$(samples_run)" ""
}

@test "an interrupted study leaves whole rows, and the same command finishes it" {
  run_study tables N=5
  assert_success
  mv "$study/out" "$study/undisturbed"
  # During realization 3, make is told to stop, as by a shutdown.
  before mpmrun <<<"[[ \"\$*\" != *'--sample 3 '* ]] || kill -TERM \$(<$study/make.pid)"
  run bash -c "echo \$\$ >'$study/make.pid'; exec make -C '$study' TOOLS='$tools' tables N=5"
  assert_failure
  assert_not_exist "$study/out/rows.tsv"
  assert_not_exist "$study/out/rows/000003.tsv"
  assert_equal "$(find "$study/out/rows" -type f ! -name '00000?.tsv')" ""
  local row
  for row in "$study"/out/rows/*; do assert_schema row "$row"; done
  rm "$hooks/before.mpmrun"
  forget_calls
  run_study tables N=5
  assert_success
  assert_equal "$(samples_run)" "3 4 5"
  assert_equal "$(sums "$study/out")" "$(sums "$study/undisturbed")"
}

@test "a run that diverged is a row that is counted" {
  before mpmrun <<'END'
if [[ "$*" == *'--sample 2 '* ]]; then
  "$real/mpmrun" "$@"
  sed -i -E 's/^2\t\w+\t[^\t]*\t[^\t]*/2\tdiverged\tnan\tnan/' "${@: -1}"
  exit
fi
END
  run_study N=5
  assert_success
  assert_output --partial "1 diverged"
  run awk '$1 == "runs" && $2 == "diverged" { print $3 }' "$study/out/statistics.tsv"
  assert_output 1
}

@test "a study of which every run diverged comes to its end and says so" {
  before mpmrun <<'END'
if [[ "$*" == *'-o out/rows/'* ]]; then
  "$real/mpmrun" "$@"
  sed -i -E 's/^([0-9]+)\t\w+\t[^\t]*\t[^\t]*/\1\tdiverged\tnan\tnan/' "${@: -1}"
  exit
fi
END
  run_study N=3
  assert_success
  assert_output --partial "0 slid, 0 stable, 0 left the grid, 3 diverged"
  assert_output --partial "unknown, perhaps very high"
}

@test "a tool that fails stops the study and leaves no row" {
  before mpmrun <<<"exit 70"
  run_study tables N=2
  assert_failure 2
  assert_equal "$(find "$study/out/rows" -type f)" ""
}

@test "thousands of rows pass, more than a command line holds" {
  run_study rows N=2
  assert_success
  # Fields, points and rows as if 7000 realizations had been run, from those of two.
  local last=7000
  for ((k = 51; k <= last; k += 50)); do printf "$study/out/fields/%06d.h5\n$study/out/points/%06d.h5\n" $k $k; done | xargs touch
  awk -v last=$last -v rows="$study/out/rows" '
    /^2\t/ { for (k = 3; k <= last; ++k) { file = sprintf("%s/%06d.tsv", rows, k); sub(/^[0-9]+/, k); printf "%s%s\n", head, $0 >file; close(file) } }
    { head = head $0 "\n" }' "$study/out/rows/000002.tsv"
  forget_calls
  run_study out/rows.tsv N=$last
  assert_success
  assert_equal "$(samples_run)" ""
  assert_equal "$(grep -c '^[0-9]' "$study/out/rows.tsv")" 7001
}

@test "a study drawn in pairs counts pairs" {
  sed -i 's/^realizations = .*/&\ndesign = "antithetic"/' "$study/scene.toml"
  run_study tables N=4
  assert_success
  assert_output --partial "mcstats: warning: only 2 pairs: intervals rest on what differs between them"
  assert_equal "$(awk -F '\t' '$2 == "blocks" { print $3 }' "$study/out/statistics.tsv")" 2
  assert_equal "$(grep -v '^[0#]' "$study/out/rows.tsv" | cut -f 12,13 | xargs)" "design block antithetic 1 antithetic 1 antithetic 2 antithetic 2"
}

@test "a scene without a field is one deterministic run" {
  sed -i '/^\[field/,$d' "$study/scene.toml"
  run_study
  assert_success
  assert_output --partial "With one strength everywhere"
  run cat "$calls"
  assert_equal "${#lines[@]}" 1
  assert_output --regexp '^mpmrun '
  assert_schema row "$study/out/shown/row.tsv"
  assert_exist "$study/out/slope.png"
}

@test "a wrong N, a broken scene, missing tools: a message, and nothing is made" {
  run_study N=1
  assert_failure
  assert_output --partial "N, the number of realizations, is '1': give a whole number from 2"
  run_study N=010
  assert_failure
  assert_output --partial "N, the number of realizations, is '010'"
  echo 'x = [' >>"$study/scene.toml"
  run_study
  assert_failure
  assert_output --partial "scene.toml: tomllib"
  cp "$TOP/tests/scenes/tiny.toml" "$study/scene.toml"
  PATH=/usr/bin:/bin run make -C "$study" TOOLS=nowhere
  assert_failure
  assert_output --partial "rfgen is neither in nowhere nor in PATH"
  assert_equal "$(<"$calls")" ""
}

@test "through pipes the tools give the same row as through files" {
  cd "$study"
  run_study tables N=2
  assert_success
  # shellcheck disable=SC2002
  rfgen scene.toml -n 1 --first 2 | rfmap scene.toml - | mpmrun scene.toml --points - --sample 2 >piped.tsv
  run cmp <(grep -v '^#' piped.tsv) <(grep -v '^#' out/rows/000002.tsv)
  assert_success
  cat out/rows/*.tsv | mcstats | grep -v '^#' >piped.tsv
  run cmp piped.tsv <(grep -v '^#' out/statistics.tsv)
  assert_success
  cat out/rows/*.tsv | zoning --curve | grep -v '^#' >piped.tsv
  run cmp piped.tsv <(grep -v '^#' out/curve.tsv)
  assert_success
}
