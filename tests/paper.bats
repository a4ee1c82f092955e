# pipelines/paper on a tiny scene, with a stand-in for gnuplot: nine studies, what they share, verdicts.
load helper

setup() {
  cd "$BATS_TEST_TMPDIR"
  mkdir bin
  for tool in rfgen rfmap mcstats zoning; do ln -s "$SLIDEZONE_BIN/$tool" bin; done
  printf '#!/bin/bash\ntouch "$3.png" "$3.svg"\n' >bin/gnuplot
  # Calls that make a row are noted.
  printf '#!/bin/bash\n[[ "$*" != *" -o "*/rows/* ]] || echo "${@: -1}" >>%q\nexec %q "$@"\n' "$PWD/calls" "$SLIDEZONE_BIN/mpmrun" >bin/mpmrun
  chmod +x bin/*
  : >calls
}

paper() {
  run make --no-print-directory -j2 -C "$TOP/pipelines/paper" TOOLS="$PWD/bin" OUT="$PWD/out" BASE="$TOP/tests/scenes/tiny.toml" "$@"
}

@test "nine cases are run once each, from scenes that differ in scale or COV alone" {
  paper N=2
  assert_success
  assert_output --regexp 'case +against +quantity +statistic +paper +here'
  assert_equal "$(sort calls | uniq -d)" ""
  assert_equal "$(wc -l <calls)" 27  # two realizations and the deterministic run
  assert_equal "$(ls out/scenes | xargs)" \
    "12m_0.25.toml 1m_0.1.toml 1m_0.2.toml 1m_0.25.toml 1m_0.4.toml 1m_0.5.toml 24m_0.25.toml 48m_0.25.toml 6m_0.25.toml"
  assert_equal "$(diff out/scenes/1m_0.25.toml out/scenes/48m_0.25.toml | grep '^>' | grep -v title)" '> horizontal_scale = "48 m"'
  assert_equal "$(diff out/scenes/1m_0.25.toml out/scenes/1m_0.1.toml | grep '^>' | grep -v title)" '> cov = 0.1'
  # The same normals: they follow from a strength as (ln c - ln 5000 + zeta^2 / 2) / zeta, zeta^2 = ln(1 + COV^2).
  for cov in 0.1 0.4; do
    h5dump -A 0 -y -d /cohesion -s 0,2,0 -c 1,1,20 -w 1 -m %.12g "out/1m_$cov/fields/000001.h5" | grep -oE "^ *[0-9.]+,?$" | tr -d " ," |
      awk -v cov=$cov '{ zeta = sqrt(log(1 + cov * cov)); printf "%.5f\n", (log($1 / 5000) + zeta * zeta / 2) / zeta }' >normals_$cov
  done
  assert_equal "$(wc -l <normals_0.1)" 20
  cmp normals_0.1 normals_0.4
  for table in curves:curve-of-studies classes:classes-of-studies structures:structures-of-studies; do
    assert_schema "${table#*:}" "out/${table%:*}.tsv"
  done
  for picture in scales covs zones 1m_0.25/trace 48m_0.25/distribution; do assert_exist "out/$picture.png"; done
}

@test "stopped and started again, nothing is run twice; more realizations run only what is missing" {
  paper N=2 1m_0.25
  assert_success
  paper N=2
  assert_success
  assert_equal "$(wc -l <calls)" 27
  paper N=2
  assert_success
  assert_equal "$(wc -l <calls)" 27
  paper N=3
  assert_success
  assert_equal "$(wc -l <calls)" 36
  assert_equal "$(sort calls | uniq -d)" ""
}

# judged PAPER LOW HIGH STATISTIC: the verdict on a claim where ours is between LOW and HIGH.
judged() {
  mkdir -p out/against out/1m_0.25
  printf 'case\tagainst\tquantity\tstatistic\tpaper\n1m_0.25\t%s\trunout_m\t%s\t%s\n' "$5" "$4" "$1" >claims.tsv
  { printf 'quantity\tstatistic\tvalue\tci_low\tci_high\tn\n'
    for quantity in influence_m runout_m; do for statistic in mean sd; do printf '%s\t%s\t1\t%s\t%s\t9\n' $quantity $statistic "$2" "$3"; done; done
    printf 'runout_m\t%s\t1\t%s\t%s\t9\n' "$4" "$2" "$3"; } | tee out/1m_0.25/statistics.tsv >out/against/1m_0.25.tsv
  "$TOP/pipelines/paper/compare" claims.tsv out 1m_0.25
  tail -1 out/verdicts.tsv | cut -f 10
}

@test "verdicts follow from interval and claim" {
  assert_equal "$(judged 2 1.5 2.5 mean .)" agrees
  assert_equal "$(judged 2 2.1 2.5 mean .)" differs
  assert_equal "$(judged 2 1.5 unbounded mean .)" "no interval"
  assert_equal "$(judged 2 nan nan mean .)" "no interval"
  assert_equal "$(judged 2 2.5 unbounded mean .)" differs
  assert_equal "$(judged 2 0.1 1.5 mean_difference b)" "trend agrees"
  assert_equal "$(judged 2 -0.1 1.5 mean_difference b)" differs
  assert_equal "$(judged grows 0.1 1.5 mean_difference b)" "trend agrees"
  assert_equal "$(judged grows -0.1 1.5 mean_difference b)" undecided
  assert_equal "$(judged grows -1 -0.5 mean_difference b)" differs
  assert_equal "$(judged grows 0.9 1.2 sd_ratio b)" undecided
  assert_equal "$(judged grows 1.1 1.2 sd_ratio b)" "trend agrees"
  printf '1m_0.25\t.\trunout_m\tdeterministic\t9\n' >>claims.tsv
  "$TOP/pipelines/paper/compare" claims.tsv out 1m_0.25
  assert_equal "$(tail -1 out/verdicts.tsv | cut -f 6,10)" "nan	no interval"
}
