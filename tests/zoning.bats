# zoning: contract, bad rows and structures, then bands and boundaries against closed forms and reference numbers.
load helper
load rows

setup() { cd "$BATS_TEST_TMPDIR"; }

structures() { printf '%s\n' 'name side distance_m' "$@" | tr ' ' '\t'; }

# field WORD COLUMN <TABLE: the column's field of the first line that holds the word as a field.
field() { awk -F '\t' -v w="$1" -v c="$2" '!/^#/ { for (i = 1; i <= NF; ++i) if ($i == w) { print $c; exit } }'; }

# ---- contract ----

@test "help, version, unknown option, missing input" { check_contract zoning; }

@test "the help explains every column and class" {
  run zoning --help
  for word in quantity distance_m probability ci_low ci_high normal lognormal class_low class_high very_high very_low unbounded; do
    assert_output --partial "$word"
  done
}

@test "one kind of result at a time" {
  ladder 3 >rows.tsv
  structures 'A toe 1' >s.tsv
  run -64 zoning rows.tsv --curve --classes
  run -64 zoning rows.tsv --curve --structures s.tsv
  run -64 zoning rows.tsv --classes --structures s.tsv
  run -64 zoning rows.tsv --curve --tail
  run -64 zoning rows.tsv --study a=rows.tsv
  run -64 zoning --study a=- --study b=- <rows.tsv
  run -64 zoning --structures - <rows.tsv
  assert_output --partial "can come from stdin"
}

@test "wrong thresholds, names, bands and studies are a wrong command line" {
  ladder 3 >rows.tsv
  for wrong in '--thresholds 0.1,0.2' '--thresholds 0.5,0.5' '--thresholds 0.5' '--thresholds 1,0.1' '--thresholds nan' \
    '--class-names a,b' '--band wide'; do
    run --separate-stderr zoning rows.tsv $wrong
    assert_failure 64
    assert_equal "$output" ""
  done
  for wrong in rows.tsv =rows.tsv a= worst_case=rows.tsv 'a b=rows.tsv' a:b=rows.tsv; do run -64 zoning --study "$wrong"; done
  run -64 zoning --study a=rows.tsv --study a=rows.tsv
  assert_output --partial "'a' stands twice"
}

@test "broken rows are named by file and line" {
  { row_header; row 1 slid 1 2; row 2 slid nan 2; } >wrong.tsv
  for kind in --classes --curve; do
    run --separate-stderr zoning wrong.tsv "$kind"
    assert_failure 65
    assert_equal "$output" ""
    assert_equal "$stderr" "zoning: wrong.tsv:5: column 'influence_m': found 'nan', expected a finite number"
  done
}

@test "one random row, and slides that all run equally far, are refused" {
  { row_header; row 1 slid 1 2; } >one.tsv
  run -65 zoning one.tsv
  assert_output --partial "one.tsv:4: found one random realization"
  { row_header; row 1 slid 1 2; row 2 slid 2 2; } >equal.tsv
  run -65 zoning equal.tsv --curve
  assert_output --partial "equal.tsv:5: column 'runout_m': found 2 in each of the 2 runs that slid"
}

@test "broken structures are named by file and line" {
  ladder 3 >rows.tsv
  for wrong in 'A left 1' 'A toe -1' 'A toe nan' 'A toe 1m' ' toe 1' 'A toe'; do
    structures 'House crest 3' "$wrong" >wrong.tsv
    run --separate-stderr zoning rows.tsv --structures wrong.tsv
    assert_failure 65
    assert_equal "$output" ""
    assert_regex "$stderr" '^zoning: wrong.tsv:3: '
  done
  structures 'A toe 1' 'A toe 2' >wrong.tsv
  run -65 zoning rows.tsv --structures wrong.tsv
  assert_output --partial "wrong.tsv:3: structure 'A' stands twice"
  structures >wrong.tsv
  run -65 zoning rows.tsv --structures wrong.tsv
  structures 'A toe 1' | sed 's/distance_m/distance/' >wrong.tsv
  run -65 zoning rows.tsv --structures wrong.tsv
  assert_output --partial "no column 'distance_m'"
  run -66 zoning rows.tsv --structures absent.tsv
}

@test "an output that cannot be written leaves nothing" {
  ladder 3 >rows.tsv
  run -73 zoning -q rows.tsv -o no/such/folder
  run -74 bash -c 'zoning -q rows.tsv >/dev/full'
  assert_equal "$(ls)" rows.tsv
}

@test "the same rows give the same bytes: file, pipe, parts in any order" {
  ladder 30 >rows.tsv
  head -13 rows.tsv >a.tsv
  { row_header; tail -n +14 rows.tsv; } >b.tsv
  structures 'A toe 10.2' >s.tsv
  for kind in --classes --curve '--structures s.tsv'; do
    zoning -q rows.tsv $kind >whole
    zoning -q $kind <rows.tsv | cmp - whole
    cat b.tsv a.tsv | zoning -q $kind | cmp - whole
    zoning -q b.tsv a.tsv $kind -o output
    cmp output whole
  done
}

@test "classes are the default" {
  ladder 30 >rows.tsv
  cmp <(zoning -q rows.tsv) <(zoning -q rows.tsv --classes)
}

@test "every table obeys its schema" {
  structures 'A toe 10.2' 'B crest 0' >s.tsv
  assert_schema structures-input s.tsv
  { row_header; row 1 slid 10 20; row 2 stable 0 0.1; row 3 left_domain 12 30; row 4 diverged nan nan; } >few.tsv
  ladder 1000 >many.tsv
  { row_header; row 1 diverged nan nan; row 2 diverged nan nan; } >none.tsv
  for rows in few many none; do
    zoning -q $rows.tsv >classes 2>/dev/null
    assert_schema classes classes
    zoning -q $rows.tsv --curve >curve 2>/dev/null
    assert_schema curve curve
    zoning -q $rows.tsv --structures s.tsv >structures 2>/dev/null
    assert_schema structures structures
    zoning -q --tail $rows.tsv >classes 2>/dev/null
    assert_schema classes classes
  done
  for kind in --classes --curve '--structures s.tsv'; do
    zoning -q --study few=few.tsv --study many=many.tsv --study none=none.tsv $kind >several 2>/dev/null
    kind=${kind%% *}
    assert_schema "${kind#--}-of-studies" several
  done
}

# ---- bands and boundaries ----

@test "boundaries of 1 ... 1000 carry the reference ranks, and no upper end at 0.1 %" {
  ladder 1000 | zoning >classes
  for line in very_high:0.5:5.005:4.69:5.32 high:0.1:9.005:8.81:9.19 medium:0.01:9.905:9.83:9.97; do
    IFS=: read -r class probability distance low high <<<"$line"
    assert_equal "$(field $class 3 <classes)" $probability
    assert_near "$(field $class 4 <classes)" $distance 1e-12
    assert_equal "$(field $class 5 <classes)" $low
    assert_equal "$(field $class 6 <classes)" $high
  done
  assert_near "$(field low 4 <classes)" 9.995 1e-12
  assert_equal "$(field low 5 <classes)" 9.97
  assert_equal "$(field low 6 <classes)" unbounded
}

@test "few runs say which boundaries they cannot tell" {
  ladder 24 >rows.tsv
  run --separate-stderr zoning rows.tsv
  assert_success
  assert_regex "$stderr" 'note: 24 runs cannot tell where the probability falls to 1 %'
  assert_regex "$stderr" 'falls to 0.1 %'
}

@test "the curve carries the exact binomial band" {
  ladder 1000 | zoning --curve >curve
  line=$(awk -F '\t' '$1 == "influence_m" && $2 == "9.9"' curve)
  assert_equal "$(cut -f 3 <<<"$line")" 0.01
  assert_near "$(cut -f 4 <<<"$line")" 0.0048055107 1e-10
  assert_near "$(cut -f 5 <<<"$line")" 0.0183132431 1e-10
  line=$(awk -F '\t' '$1 == "runout_m"' curve | tail -1)
  assert_equal "$(cut -f 3 <<<"$line")" 0
  assert_near "$(cut -f 5 <<<"$line")" 0.0036820839 1e-10
}

@test "the curve falls, over distances that rise, with the fits beside it" {
  ladder 200 | zoning --curve >curve
  awk -F '\t' '/^#|^quantity/ { next } $1 == q && ($2 <= d || $3 > p || $6 > f) { exit 1 } { q = $1; d = $2; p = $3; f = $6 }' curve
  run awk -F '\t' '$1 == "influence_m" && $2 == 1 { print $6 }' curve
  assert_near "$output" 0.5035 0.01  # the Normal fit near its mean of 1.005, sd 0.579
}

@test "structures get the class of their distance and the classes of its band" {
  ladder 1000 >rows.tsv
  structures 'school toe 19.9' 'road toe 12' 'mast crest 9.8' 'far crest 99' >s.tsv
  zoning rows.tsv --structures s.tsv >classed
  assert_equal "$(field school 4 <classed)" 0.01
  assert_equal "$(field school 7 <classed)" low
  assert_equal "$(field school 8 <classed)" low
  assert_equal "$(field school 9 <classed)" medium
  assert_equal "$(field road 4 <classed)" 0.8
  assert_equal "$(field road 7 <classed)" very_high
  assert_equal "$(field mast 7 <classed)" medium
  assert_equal "$(field far 7 <classed)" very_low
  assert_equal "$(field far 9 <classed)" low  # 0 of 1000 still allows 0.37 %
}

@test "runs that left the grid or diverged widen the band, with a warning" {
  { ladder 8; row 9 left_domain 0.5 10.5; row 10 diverged nan nan; } >rows.tsv
  structures 'near crest 0.3' 'far crest 1' >s.tsv
  run --separate-stderr zoning rows.tsv --structures s.tsv
  assert_success
  assert_regex "$stderr" 'warning: 1 of the runs left the grid'
  assert_regex "$stderr" 'warning: 1 of the runs diverged'
  printf '%s\n' "$output" >classed
  assert_near "$(field near 4 <classed)" 0.1111111111111111 1e-15  # 1 of the 9 that tell
  assert_near "$(field near 5 <classed)" 0.0025285785 1e-10        # 1 of 10: 1 - 0.975^(1/10)
  assert_equal "$(field far 4 <classed)" 0
  assert_near "$(field far 6 <classed)" 0.55609546 1e-8            # 2 of 10, as binom.test of R prints it
}

@test "stable runs count: probabilities are of all runs, failed or not" {
  { row_header; row 1 slid 5 10; row 2 slid 6 12; row 3 stable 0 0; row 4 stable 0 0; } >rows.tsv
  structures 'A toe 11' >s.tsv
  zoning rows.tsv --structures s.tsv >classed
  assert_equal "$(field A 4 <classed)" 0.25
  zoning rows.tsv --curve >curve
  assert_equal "$(awk -F '\t' '$1 == "runout_m" && $2 == 11 { print $6 }' curve)" 0.25  # P(failure) times the Normal tail at its mean
}

# ---- bands, thresholds, tails, several studies ----

@test "Wilson's and the simultaneous band on request" {
  ladder 1000 >rows.tsv
  structures 'A crest 9.9' 'B crest 99' >s.tsv
  zoning rows.tsv --structures s.tsv --band wilson >classed
  assert_near "$(field A 5 <classed)" 0.0054407544 1e-10  # reference values for 10 and 0 of 1000
  assert_near "$(field A 6 <classed)" 0.0183094689 1e-10
  assert_near "$(field B 6 <classed)" 0.0038267585 1e-10
  zoning rows.tsv --structures s.tsv --band simultaneous >classed
  assert_equal "$(field A 5 <classed)" 0
  assert_near "$(field A 6 <classed)" 0.0529469408 1e-10  # 0.01 + sqrt(ln 40 / 2000)
}

@test "thresholds and names of one's own" {
  ladder 1000 >rows.tsv
  structures 'A crest 9.7' 'B crest 5' >s.tsv
  zoning rows.tsv --thresholds 0.2,0.02 --class-names red,orange,green >classes
  assert_near "$(field red 4 <classes)" 8.005 1e-12
  assert_near "$(field orange 4 <classes)" 9.805 1e-12
  assert_equal "$(grep -c green classes)" 0
  zoning rows.tsv --thresholds 0.2,0.02 --class-names red,orange,green --structures s.tsv >classed
  assert_equal "$(field A 7 <classed)" orange
  assert_equal "$(field B 7 <classed)" red
}

# exponential COUNT: quantiles of an exponential reach of mean 1 m, whose tail has shape 0.
exponential() {
  row_header
  awk -v n="$1" 'BEGIN { OFS = "\t"
    for (k = 1; k <= n; ++k) { x = -log((k - 0.5) / n); print k, "slid", x, x + 10, 0, 0, 0, 10, 100, 0.001, 0 } }'
}

@test "a tail gives the 0.1 % boundary an upper end, and says how it was fitted" {
  exponential 1000 >rows.tsv
  zoning rows.tsv --tail >classes
  assert_near "$(field low 4 <classes)" 6.9078 0.3  # ln 1000; the fit's shape is off zero by some hundredths
  assert_between "$(field low 5 <classes)" 5 6.9
  assert_between "$(field low 6 <classes)" 6.91 12
  assert_equal "$(field very_high 4 <classes)" "$(zoning -q rows.tsv | field very_high 4)"
  run grep '^# tail of runout_m: threshold 12\.[0-9]* m, exceedances 100, scale .* shape .* distance ' classes
  assert_success
}

@test "no tail of few runs, nor of censored ones: order statistics and a warning" {
  exponential 40 >few.tsv
  { exponential 1000; row 1001 left_domain 3 13; } >censored.tsv
  for rows in few.tsv censored.tsv; do
    run --separate-stderr zoning $rows --tail
    assert_success
    assert_regex "$stderr" 'warning: no tail fitted to runout_m'
    diff <(zoning -q $rows 2>/dev/null | grep -v '^#') <(grep -v '^#' <<<"$output")
  done
}

@test "several studies stand below each other, then the worst case of each line" {
  ladder 100 >short.tsv
  ladder 200 >long.tsv
  { row_header; for k in 1 2 3 4; do row $k slid 0.9 30.$k; done; } >far.tsv
  structures 'A toe 10.8' 'B crest 0.5' >s.tsv
  zoning --study short=short.tsv --study long=long.tsv --study far=far.tsv --structures s.tsv >classed
  assert_equal "$(grep -v '^#' classed | cut -f 1 | xargs)" "study short short long long far far worst_case worst_case"
  assert_equal "$(grep -P '^short\tA' classed | cut -f 5)" 0.2
  assert_equal "$(grep -P '^long\tA' classed | cut -f 5)" 0.6
  assert_equal "$(grep -P '^worst_case\tA' classed | cut -f 5)" 1
  assert_equal "$(grep -P '^worst_case\tA' classed | cut -f 6)" "$(grep -P '^long\tA' classed | cut -f 6)"  # 120 of 200 bound it better
  zoning -q --study short=short.tsv --study long=long.tsv >classes
  assert_equal "$(grep -P '^worst_case\t' classes | cut -f 2-)" "$(grep -P '^long\t' classes | cut -f 2-)"
  zoning -q --study short=short.tsv --study long=long.tsv --curve >curve
  cmp <(grep -P '^worst_case\trunout_m' curve | cut -f 3-5) <(grep -P '^long\trunout_m' curve | cut -f 3-5)
  # Beyond all runs the upper end is that of the fewer runs.
  assert_equal "$(grep -P '^worst_case' curve | tail -1 | cut -f 6)" "$(grep -P '^short' curve | tail -1 | cut -f 6)"
}

# ---- map ----

# site_scene: the least scene that has a site facing east, with a face of 5 m.
site_scene() {
  printf '[slope]\nheight = "5 m"\nlength = "25 m"\nangle = "45 deg"\n[site]\ncrest = ["1000 m", "500 m"]\ntoe = ["1005 m", "500 m"]\nepsg = 25832\nwidth = "10 m"\n'
}

# in_map EXPRESSION: its value in Python, m being the map.
in_map() { python3 -c 'import json, sys; m = json.load(open("zones.geojson")); print(eval(sys.argv[1]))' "$1"; }

@test "the map carries zones and structures to their places" {
  ladder 1000 >rows.tsv
  site_scene >scene.toml
  { structures; printf 'the "A" house\ttoe\t12.5\nmast\tcrest\t3\n'; } >s.tsv
  zoning rows.tsv --map scene.toml --structures s.tsv -o zones.geojson
  assert_schema map zones.geojson
  assert_equal "$(in_map 'm["crs"]["properties"]["name"]')" urn:ogc:def:crs:EPSG::25832
  assert_equal "$(in_map 'len(m["features"])')" 10  # four classes on either side, two structures
  # The 50 % boundary of runout is 15.005 m from the toe, which stands at 1005 m: the strip goes from 1005 to 1020.005 m, 10 m wide.
  assert_equal "$(in_map '[f for f in m["features"] if f["properties"].get("quantity") == "runout_m"][0]["geometry"]["coordinates"][0]')" \
    "[[1005.0, 495.0], [1020.005, 495.0], [1020.005, 505.0], [1005.0, 505.0], [1005.0, 495.0]]"
  assert_equal "$(in_map '[f["properties"]["ci_high_m"] for f in m["features"] if f["properties"].get("class") == "low"][0]')" None
  assert_equal "$(in_map 'm["features"][8]["properties"]["name"]')" 'the "A" house'
  assert_equal "$(in_map 'm["features"][8]["geometry"]["coordinates"]')" "[1017.5, 500.0]"
  assert_equal "$(in_map 'm["features"][9]["geometry"]["coordinates"]')" "[997.0, 500.0]"
  assert_equal "$(in_map 'm["features"][9]["properties"]["class"]')" very_high
}

@test "classes of no width are left out of the map; few runs and doubtful ones still obey the schema" {
  site_scene >scene.toml
  { row_header; row 1 slid 0 10; row 2 slid 0 12; row 3 left_domain 1 30; row 4 diverged nan nan; } >few.tsv
  zoning -q few.tsv --map scene.toml -o zones.geojson 2>/dev/null
  assert_schema map zones.geojson
  exponential 1000 >rows.tsv
  zoning rows.tsv --map scene.toml --tail -o zones.geojson
  assert_schema map zones.geojson
  assert_regex "$(in_map 'm["tail of runout_m"]')" '^threshold 12'
}

@test "a toe that the map puts far from the crest is told" {
  ladder 1000 >rows.tsv
  site_scene | sed 's/"1005 m"/"10005 m"/' >scene.toml
  run --separate-stderr zoning --quiet rows.tsv --map scene.toml
  assert_success
  assert_equal "$stderr" "zoning: warning: scene.toml: [site] puts the toe 9005 m from the crest, the section 5 m"
}

@test "a map wants a scene with a site, and stands alone" {
  ladder 3 >rows.tsv
  site_scene | sed '/^\[site\]/,$d' >scene.toml
  run -65 zoning rows.tsv --map scene.toml
  assert_output --partial "no table [site] in the scene"
  site_scene >scene.toml
  run -64 zoning rows.tsv --map scene.toml --curve
  run -64 zoning rows.tsv --map scene.toml --classes
  run -64 zoning --study a=rows.tsv --map scene.toml
  run -64 zoning - --map - <scene.toml
  run -66 zoning rows.tsv --map absent.toml
}

@test "pairs that agree count once: bands and boundaries are those of as many pairs, almost" {
  pairs 100 | awk -F '\t' -v OFS='\t' '/^[0-9]/ { $3 = 5 + $13 / 10; $4 = 15 + $13 / 10 } { print }' >rows.tsv
  zoning rows.tsv --curve >curve
  { row_header; for ((k = 1; k <= 100; ++k)); do row $k slid "$(awk "BEGIN { print 5 + $k / 10 }")" "$(awk "BEGIN { print 15 + $k / 10 }")"; done; } >half.tsv
  zoning half.tsv --curve >half
  # Korn and Graubard's: n_eff = 200 / (200 / 199 * 99 / 100 ... ) within 3 % of 100.
  for distance in 17 20 23; do
    for end in 4 5; do
      assert_near "$(awk -F '\t' -v d=$distance -v e=$end '$1 == "runout_m" && $2 == d { print $e }' curve)" \
        "$(awk -F '\t' -v d=$distance -v e=$end '$1 == "runout_m" && $2 == d { print $e }' half)" 0.005
    done
  done
  zoning rows.tsv >classes
  zoning half.tsv >half
  assert_near "$(awk -F '\t' '$1 == "runout_m" && $3 == 0.5 { print $6 }' classes)" "$(awk -F '\t' '$1 == "runout_m" && $3 == 0.5 { print $6 }' half)" 0.11
  run --separate-stderr zoning rows.tsv --tail
  assert_regex "$stderr" 'no tail fitted to runout_m: .* depend on each other'
}
