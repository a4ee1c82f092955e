# mcstats: contract, bad rows, then statistics against closed forms and reference numbers.
load helper
load rows

setup() { cd "$BATS_TEST_TMPDIR"; }

# value QUANTITY STATISTIC [COLUMN] <STATISTICS: a field of the line, column 3 (value) by default.
value() { awk -F '\t' -v q="$1" -v s="$2" -v c="${3:-3}" '$1 == q && $2 == s { print $c }'; }

# refuses LINE...: mcstats finds fault with a table of these rows and names the place.
refuses() {
  { row_header; printf '%s\n' "$@"; } >wrong.tsv
  run --separate-stderr mcstats wrong.tsv
  assert_failure 65
  assert_equal "$output" ""
  assert_regex "$stderr" '^mcstats: wrong.tsv:[0-9]+: '
}

# ---- contract ----

@test "help, version, unknown option, missing input" { check_contract mcstats; }

@test "the help explains every column and rule" {
  run mcstats --help
  for word in quantity statistic value ci_low ci_high unbounded probability_of_failure quantile_P exceeds_deterministic paper mean=W; do
    assert_output --partial "$word"
  done
}

@test "a wrong stopping rule is a wrong command line" {
  ladder 3 >rows.tsv
  run -64 mcstats rows.tsv --trace --histogram
  run -64 mcstats rows.tsv --resamples 10
  run -64 mcstats rows.tsv --seed -3
  for rule in mean=0 mean=nan mean sd=1x quantile_2=1 ''; do
    run --separate-stderr mcstats rows.tsv --stop "$rule"
    assert_failure 64
  done
}

@test "broken rows are named by file and line" {
  refuses "$(row 1 slid nan 2)"
  assert_equal "$stderr" "mcstats: wrong.tsv:4: column 'influence_m': found 'nan', expected a finite number"
  refuses "$(row 1 slid inf 2)"
  refuses "$(row 1 slid 1 2m)"
  refuses "$(row 1 slipped 1 2)"
  refuses "$(row -1 slid 1 2)"
  refuses "$(row 1 slid 1 2)" "$(row 1 slid 1 3)"
  refuses "$(row 1 slid 1 2)" "$(row 1 slid 1 2)"
  refuses "1 slid 1 2"
}

@test "empty tables, other schemas and unknown columns are refused" {
  : >empty.tsv
  run -65 mcstats empty.tsv
  row_header >header.tsv
  run -65 mcstats header.tsv
  assert_output --partial "without rows"
  { row_header; row 0 slid 1 2; } >deterministic.tsv
  run -65 mcstats deterministic.tsv
  assert_output --partial "deterministic.tsv:4: found only realization 0"
  ladder 3 | sed 's/row 1/curve 1/' >other.tsv
  run -65 mcstats other.tsv
  assert_output --partial "other.tsv:1: found schema 'slidezone-curve 1', expected 'slidezone-row 1'"
  ladder 3 | sed 's/runout_m\t/runuot_m\t/' >column.tsv
  run -65 mcstats column.tsv
  assert_output --partial "column.tsv:3: no column 'runout_m'"
}

@test "an output that cannot be written leaves nothing" {
  ladder 3 >rows.tsv
  run -73 mcstats rows.tsv -o no/such/folder
  run -74 bash -c 'mcstats rows.tsv >/dev/full'
  run -74 mcstats rows.tsv -o /dev/full
  assert_equal "$(ls)" rows.tsv
}

@test "the same rows give the same bytes: file, pipe, parts in any order" {
  ladder 30 >rows.tsv
  mcstats rows.tsv >whole
  mcstats <rows.tsv | cmp - whole
  mcstats rows.tsv -o output
  cmp output whole
  head -13 rows.tsv >a.tsv
  { row_header; tail -n +14 rows.tsv; } >b.tsv
  mcstats b.tsv a.tsv | cmp - whole
  cat b.tsv a.tsv | mcstats | cmp - whole
}

@test "another seed moves the bootstrap and nothing else" {
  ladder 30 >rows.tsv
  mcstats rows.tsv --seed 2 >second
  mcstats rows.tsv >first
  run -1 cmp first second
  assert_equal "$(value influence_m quantile_0.5 5 <first)" "$(value influence_m quantile_0.5 5 <second)"
  refute [ "$(value influence_m bootstrap_mean 4 <first)" = "$(value influence_m bootstrap_mean 4 <second)" ]
}

@test "the table obeys its schema, also of runs that say little or nothing" {
  ladder 30 | mcstats >many
  assert_schema statistics many
  { row_header; row 1 diverged nan nan; row 2 diverged nan nan; } | mcstats >none
  assert_schema statistics none
  assert_equal "$(value influence_m mean <none)" nan
  stable() { row 1 stable 0 0; row 2 stable 0 0; }
  diverged() { row 1 diverged nan nan; row 2 diverged nan nan; }
  for rows in 'ladder 30' 'ladder 2' stable diverged; do
    for kind in trace histogram densities; do
      { row_header; $rows; } | mcstats --$kind >$kind
      assert_schema $kind $kind
    done
  done
}

@test "one random row is refused: it has no spread" {
  { row_header; row 0 slid 9 18; row 7 slid 10 20; } >one.tsv
  run --separate-stderr mcstats one.tsv
  assert_failure 65
  assert_equal "$output" ""
  assert_equal "$stderr" "mcstats: one.tsv:5: found one random realization, statistics want at least two; mpmrun's row says what there is to say of one"
}

@test "slides that all run equally far are refused, with file and line" {
  refuses "$(row 1 slid 1 20)" "$(row 2 stable 0 0.1)" "$(row 3 slid 2 20)"
  assert_equal "$stderr" "mcstats: wrong.tsv:6: column 'runout_m': found 20 in each of the 2 runs that slid, expected that they differ; were runs copied, or does the field not vary?"
}

@test "slopes that all stand: the probability of failure is told, the spread of what is the same is not" {
  { row_header; for ((k = 1; k <= 30; ++k)); do row $k stable 0 0.1$k; done; } >rows.tsv
  run --separate-stderr mcstats rows.tsv
  assert_success
  assert_equal "$stderr" "mcstats: warning: influence_m is 0 in all 30 runs: they tell nothing of its spread, and its mean has no interval"
  printf '%s\n' "$output" >statistics
  assert_schema statistics statistics
  assert_equal "$(value runs probability_of_failure <statistics)" 0
  assert_near "$(value runs probability_of_failure 5 <statistics)" 0.115703308 1e-8  # 1 - 0.025^(1/30)
  assert_equal "$(value influence_m mean <statistics)" 0
  assert_equal "$(value influence_m mean 5 <statistics)" unbounded
  for statistic in variance sd skewness kurtosis standard_error_of_mean bootstrap_mean bootstrap_sd; do
    assert_equal "$(value influence_m $statistic <statistics)" nan
    assert_equal "$(value influence_m $statistic 5 <statistics)" nan
    assert_finite "$(value runout_m $statistic <statistics)"
  done
  assert_equal "$(value influence_m stop:mean=0.2 <statistics)" 0
}

# ---- statistics ----

@test "moments, quantiles and their intervals of 1 ... 1000" {
  ladder 1000 | mcstats >statistics
  assert_near "$(value influence_m mean <statistics)" 5.005 1e-12
  assert_near "$(value influence_m variance <statistics)" 8.3416666666666667 1e-11  # (n^2 - 1) / 12 * n / (n - 1) / 100^2
  assert_near "$(value runout_m mean <statistics)" 15.005 1e-12
  assert_equal "$(value influence_m min <statistics)" 0.01
  assert_equal "$(value influence_m max <statistics)" 10
  assert_near "$(value influence_m quantile_0.5 <statistics)" 5.005 1e-12
  # The reference ranks [469, 532] and [983, 997] of 1000.
  assert_equal "$(value influence_m quantile_0.5 4 <statistics)" 4.69
  assert_equal "$(value influence_m quantile_0.5 5 <statistics)" 5.32
  assert_equal "$(value influence_m quantile_0.99 4 <statistics)" 9.83
  assert_equal "$(value influence_m quantile_0.99 5 <statistics)" 9.97
  assert_equal "$(value influence_m quantile_0.99 6 <statistics)" 1000
}

@test "quantiles that few runs cannot bound are unbounded" {
  ladder 24 | mcstats >statistics
  assert_equal "$(value runout_m quantile_0.99 5 <statistics)" unbounded
  assert_equal "$(value runout_m quantile_0.01 4 <statistics)" unbounded
}

@test "every status is counted and none is dropped without a word" {
  { row_header; row 1 slid 10 20; row 2 slid 11 21; row 3 stable 0 0.1; row 4 left_domain 12 30; row 5 diverged nan nan; } >rows.tsv
  run --separate-stderr mcstats rows.tsv
  assert_success
  assert_regex "$stderr" 'mcstats: warning: 1 of the runs left the grid'
  assert_regex "$stderr" 'mcstats: warning: 1 of the runs diverged'
  printf '%s\n' "$output" >statistics
  for status in slid:2 stable:1 left_domain:1 diverged:1 total:5; do
    assert_equal "$(value runs "${status%:*}" <statistics)" "${status#*:}"
  done
  assert_equal "$(value runs probability_of_failure <statistics)" 0.75
  assert_near "$(value runout_m mean <statistics)" 17.775 1e-12  # with the stable run, and the censored one at its lower bound
  assert_equal "$(value runout_m mean 5 <statistics)" unbounded
  assert_equal "$(value runout_m mean 6 <statistics)" 4
  assert_equal "$(value runout_m mean_of_slides <statistics)" 20.5
}

@test "no warning where every run is complete" {
  ladder 5 >rows.tsv
  run --separate-stderr mcstats rows.tsv
  assert_equal "$stderr" ""
}

@test "realization 0 is compared with, not mixed in" {
  ladder 100 >random.tsv
  { row_header; row 0 slid 0.3 10.9; } >deterministic.tsv
  mcstats random.tsv deterministic.tsv >statistics
  assert_equal "$(value runs total <statistics)" 100
  assert_equal "$(value influence_m exceeds_deterministic <statistics)" 0.7
  assert_equal "$(value influence_m reaches_deterministic <statistics)" 0.71
  assert_equal "$(value runout_m exceeds_deterministic <statistics)" 0.1
}

@test "skewness and kurtosis of 1 ... 1000 are those of a uniform distribution" {
  ladder 1000 | mcstats >statistics
  assert_near "$(value runout_m skewness <statistics)" 0 1e-12
  assert_near "$(value runout_m kurtosis <statistics)" 1.8 1e-5  # 9/5 - 12/5 / (n^2 - 1)
  assert_between 1.8 "$(value runout_m kurtosis 4 <statistics)" "$(value runout_m kurtosis 5 <statistics)"
  # Both intervals of the sd hold without a Normal: 2.8882 +- 1.96 * 2.8882 sqrt((1.8 - 1) / 1000) / 2 = 2.8882 +- 0.0801.
  for statistic in sd bootstrap_sd; do
    assert_near "$(value runout_m $statistic 4 <statistics)" 2.8081 0.01
    assert_near "$(value runout_m $statistic 5 <statistics)" 2.9683 0.01
  done
  assert_near "$(value runout_m standard_error_of_sd <statistics)" 0.04085 0.0001
}

@test "the trace ends where the statistics stand" {
  ladder 200 >rows.tsv
  mcstats rows.tsv >statistics
  last=$(mcstats rows.tsv --trace | grep influence_m | tail -1)
  assert_equal "$(cut -f 2 <<<"$last")" 200
  assert_equal "$(cut -f 3 <<<"$last")" "$(value influence_m mean <statistics)"
  assert_equal "$(cut -f 5 <<<"$last")" "$(value influence_m mean 5 <statistics)"
  assert_equal "$(cut -f 6 <<<"$last")" "$(value influence_m sd <statistics)"
}

@test "the histogram counts every slide once, over a density of one" {
  { ladder 200; row 201 stable 0 0; } | mcstats --histogram >histogram
  awk -F '\t' '$1 == "runout_m" { count += $4; area += $5 * ($3 - $2) } END { exit !(count == 200 && area > 0.999999 && area < 1.000001) }' histogram
  awk -F '\t' '$1 == "runout_m" { if (high != "" && $2 != high) exit 1; high = $3 }' histogram
}

@test "densities integrate to one and cumulatives rise to it" {
  ladder 200 | mcstats --densities >densities
  awk -F '\t' '$1 == "runout_m" { if (last != "") for (i = 4; i <= 12; i += 2) area[i] += $i * ($2 - last); last = $2; end = $3 }
    END { for (i in area) if (area[i] < 0.9 || area[i] > 1.001) exit 1; exit end != 1 }' densities
}

@test "fits and their test: a lognormal of zeros has none" {
  { row_header; row 1 slid 0 1; row 2 slid 0 2; row 3 slid 1 3; } | mcstats >statistics
  assert_equal "$(value influence_m lognormal_zeta <statistics)" nan
  assert_near "$(value runout_m normal_sd <statistics)" 1 1e-15
  assert_near "$(value runout_m lognormal_lambda <statistics)" 0.59725315640935 1e-12  # ln 6 / 3
  assert_equal "$(value runout_m normal_chi_square_p <statistics)" nan
}

@test "verdicts of the stopping rules" {
  ladder 1000 >rows.tsv
  mcstats rows.tsv --stop mean=0.17 --stop mean=0.18 --stop paper >statistics
  # Half-width t(0.975, 999) sd / sqrt(1000) = 1.96234 * 2.88820 / 31.6228 = 0.17923.
  assert_near "$(value runout_m half_width:mean=0.17 <statistics)" 0.17923 1e-5
  assert_equal "$(value runout_m stop:mean=0.17 <statistics)" 0
  assert_equal "$(value runout_m stop:mean=0.18 <statistics)" 1
  assert_equal "$(value runout_m runs_needed:mean=0.17 <statistics)" 1112
  assert_equal "$(value runout_m stop:paper <statistics)" 0
  assert_equal "$(value runout_m paper_first_met <statistics)" nan
}

@test "a rule of width waits for enough runs, and can be of one quantity" {
  ladder 99 >rows.tsv
  mcstats rows.tsv --stop runout_m:mean=9 --stop sd=9 --stop quantile_0.5=9 --stop exceeds_10.5=1 >statistics
  assert_equal "$(value runout_m stop:mean=9 <statistics)" 0
  assert_equal "$(value influence_m stop:mean=9 <statistics)" ""
  assert_equal "$(value runs next_look <statistics)" 100
  mcstats rows.tsv --least-runs 99 --stop runout_m:mean=9 --stop sd=9 --stop quantile_0.5=9 --stop exceeds_10.5=1 >statistics
  for rule in mean=9 sd=9 quantile_0.5=9 exceeds_10.5=1; do assert_equal "$(value runout_m stop:$rule <statistics)" 1; done
  assert_equal "$(value runs next_look <statistics)" 119
}

# ---- designs ----

@test "antithetic pairs: the mean is as sure as that of the pairs, the median as that of the runs at best" {
  pairs 100 >rows.tsv
  mcstats rows.tsv >statistics
  assert_schema statistics statistics
  assert_equal "$(value runs total <statistics)" 200
  assert_equal "$(value runs blocks <statistics)" 100
  # Means of pairs are 20 + k / 1000, k = 1 ... 100: sd 0.0290115, half-width t_99 * 0.00290115 with t_99 = 1.98422.
  assert_near "$(value runout_m mean <statistics)" 20.0505 1e-12
  assert_near "$(value runout_m mean 5 <statistics)" 20.0562565 1e-6
  assert_near "$(value runout_m standard_error_of_mean <statistics)" 0.00290115 1e-8
  assert_near "$(value runout_m bootstrap_mean 5 <statistics)" 20.0562 0.0005
  sed 's/antithetic.*//' rows.tsv | sed 's/\tdesign\tblock//; s/\t$//' >plain.tsv
  mcstats plain.tsv >plain
  assert_equal "$(value runout_m quantile_0.5 <statistics)" "$(value runout_m quantile_0.5 <plain)"
  assert_equal "$(value runout_m quantile_0.5 5 <statistics)" "$(value runout_m quantile_0.5 5 <plain)"
  assert_equal "$(value runout_m normal_anderson_darling <statistics)" "$(value runout_m normal_anderson_darling <plain)"
  assert_equal "$(value runout_m normal_anderson_darling_p <statistics)" nan
  mcstats rows.tsv --trace >trace
  assert_schema trace trace
  assert_equal "$(tail -1 trace | cut -f 5)" "$(value runout_m mean 5 <statistics)"
  assert_equal "$(tail -1 trace | cut -f 8)" "$(value runout_m sd 5 <statistics)"
}

@test "an incomplete pair counts and is told, and the next look is at whole pairs" {
  pairs 20 | head -n -1 >rows.tsv
  run --separate-stderr mcstats rows.tsv --least-runs 31
  assert_success
  assert_equal "$stderr" "mcstats: warning: 20 pairs, incomplete: 1; their runs count, and intervals allow for it"
  assert_equal "$(value runs total <<<"$output")" 39
  assert_equal "$(value runs next_look <<<"$output")" 48
}

@test "one block alone gives values and no intervals" {
  pairs 10 | sed 's/antithetic\t.*/Latin hypercube\t1/' >rows.tsv
  run --separate-stderr mcstats rows.tsv
  assert_success
  assert_regex "$stderr" 'only 1 block: '
  for statistic in mean quantile_0.5 bootstrap_mean; do assert_equal "$(value runout_m $statistic 5 <<<"$output")" unbounded; done
  assert_equal "$(value runs probability_of_failure 4 <<<"$output")" 0
}

@test "two designs in one table are refused by file and line" {
  pairs 3 >pairs.tsv
  { row_header; row 7 slid 1 2; } >plain.tsv
  for files in 'pairs.tsv plain.tsv' 'plain.tsv pairs.tsv'; do
    run --separate-stderr mcstats $files
    assert_failure 65
    assert_regex "$stderr" '^mcstats: (pairs|plain).tsv:4: realization [17] is of the design .* at (pairs|plain).tsv:4 of .*; statistics want one design$'
  done
}

@test "the interval that a rule of width looks at stands beside its half" {
  ladder 200 | mcstats --stop mean=1 --stop sd=1 >statistics
  assert_equal "$(value runout_m half_width:mean=1 4 <statistics)" "$(value runout_m mean 4 <statistics)"
  low=$(value runout_m half_width:sd=1 4 <statistics) high=$(value runout_m half_width:sd=1 5 <statistics)
  assert_near "$(value runout_m half_width:sd=1 <statistics)" "$(awk "BEGIN { print ($high - $low) / 2 }")" 1e-6
  assert_between "$high" "$(value runout_m sd 5 <statistics)" 1  # for a longer tail
}

@test "every family has p values by simulation, and those of gamma and gev tell a good fit from a bad one" {
  # Quantiles of a Gumbel distribution, and of two heaps.
  { row_header; awk 'BEGIN { OFS = "\t"; for (k = 1; k <= 200; ++k) { u = (k - 0.5) / 200
      print k, "slid", 10 - 1.8 * log(-log(u)), 15 + (k > 100) * 5 + u, 0, 0, 0, 10, 100, 0.001, 0 } }'; } | mcstats >statistics
  assert_between "$(value influence_m gev_anderson_darling_p <statistics)" 0.9 1
  assert_between "$(value influence_m gamma_lilliefors_p <statistics)" 0.001 1
  for family in normal lognormal gamma weibull; do assert_between "$(value runout_m ${family}_anderson_darling_p <statistics)" 0 0.005; done
}

@test "two studies compared, realization by realization" {
  ladder 100 >rows.tsv
  { row_header; for ((k = 100; k >= 1; --k)); do row $k slid "$(awk "BEGIN { print $k / 50 }")" "$(awk "BEGIN { print 12 + $k / 50 }")"; done
    row 500 slid 99 99; row 0 slid 1 1; } >other.tsv
  mcstats other.tsv --against rows.tsv >compared
  assert_schema statistics compared
  assert_near "$(value influence_m mean_difference <compared)" 0.505 1e-12
  assert_near "$(value runout_m mean_difference <compared)" 2.505 1e-12
  assert_near "$(value runout_m sd_ratio <compared)" 2 1e-12
  assert_near "$(value runout_m correlation <compared)" 1 1e-12
  assert_equal "$(value runout_m sd_ratio 6 <compared)" 100
  # 0.505 +- t_99 sd(1 ... 100) / 100 / 10
  assert_near "$(value influence_m mean_difference 5 <compared)" 0.562566 1e-5
  { row_header; row 600 slid 1 2; row 601 slid 2 3; } >none.tsv
  run -65 mcstats rows.tsv --against none.tsv
  run -64 mcstats rows.tsv --against other.tsv --trace
}
