# make converge of study.mk, with runs that are made up in place of mpmrun's: what is under test is when it looks and where it ends.
load helper
load rows

# stub NAME: an executable of that name among the study's tools, whose body is read from stdin.
stub() {
  { echo '#!/bin/bash'; cat; } >"bin/$1"
  chmod +x "bin/$1"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  mkdir bin
  ln -s "$(command -v mcstats)" "$(command -v zoning)" bin
  stub rfgen <<<'while [[ $1 != -o ]]; do shift; done; touch "$2"'
  stub rfmap <<<'while [[ $1 != -o ]]; do shift; done; touch "$2"'
  stub gnuplot <<<'touch "$3.png" "$3.svg"'
  # Realization k: runout 20 +- 1 in turn, so that the sd is 1. Each run is logged, the in-situ stage is not.
  { declare -f row row_header; cat <<'END'
k=0
while (($#)); do
  case $1 in
    --sample) k=$2 ;;
    --make-in-situ) k=stage ;;
    -o) out=$2 ;;
    --table | --profile | --state) touch "$2" ;;
  esac
  shift
done
[[ $k == stage ]] || echo "$k" >>runs.log
{ row_header; row "$k" slid "$((9 + 2 * (k % 2)))" "$((19 + 2 * (k % 2)))"; } >"$out"
END
  } | stub mpmrun
  cp "$TOP/pipelines/demo/scene.toml" .
  printf 'SCENE := scene.toml\nTOOLS := %s\ninclude %s\n' "$PWD/bin" "$TOP/pipelines/study.mk" >Makefile
}

converge() { run --separate-stderr make -j2 converge "$@"; }

# looks_at N...: the numbers of runs after which it looked, in order.
looks_at() { assert_equal "$(grep -oE 'after [0-9]+ runs' <<<"$stderr" | grep -oE '[0-9]+' | xargs)" "$*"; }

runs_done() { sort -un runs.log | grep -vc '^0$'; }  # but the deterministic one

@test "it looks at growing numbers of runs and ends where the targets are met, with the whole study made" {
  # Half-width of the mean t sd / sqrt(n): 0.238 after 71, 0.216 after 86, 0.195 after 104.
  converge LEAST=71 TARGETS=mean=0.2
  assert_success
  looks_at 71 86 104
  assert_regex "$stderr" 'every target is met after 104 runs'
  assert_equal "$(runs_done)" 104
  assert_equal "$(awk -F '\t' '$2 == "total" { print $3 }' out/statistics.tsv)" 104
  assert_exists out/zones.png
}

@test "the cap ends it, and says what is not met" {
  converge LEAST=20 CAP=26 TARGETS="mean=0.2 runout_m:sd=9"
  assert_success
  looks_at 20 24 26
  assert_regex "$stderr" 'not met after 26 runs, the cap: influence_m mean=0.2 runout_m mean=0.2'
  assert_equal "$(runs_done)" 26
}

@test "the same command goes on where it stopped: no run is made twice" {
  converge LEAST=20 CAP=24 TARGETS=mean=0.3
  converge LEAST=20 TARGETS=mean=0.3
  assert_success
  assert_regex "$stderr" 'every target is met after 51 runs'
  assert_equal "$(sort runs.log | uniq -d)" 1  # realization 1 is run once more, to be shown
}

@test "a wrong target is refused before any run" {
  converge TARGETS=mean=-1
  assert_failure
  assert_regex "$stderr" "found 'mean=-1'"
  assert_not_exists runs.log
}
