# mcstats and zoning against R and its packages nortest and boot, on the same rows.
load helper
load rows

setup() { cd "$BATS_TEST_TMPDIR"; }

# 60 rows of a skewed reach: quantiles of a Gumbel distribution, to two decimals, in an order that jumps about.
rows() {
  row_header
  awk 'BEGIN { OFS = "\t"
    for (k = 1; k <= 60; ++k) { u = ((k * 37) % 61) / 61; x = 10 - 1.8 * log(-log(u)); printf "%d\tslid\t%.2f\t%.2f\t0\t0\t0\t10\t100\t0.001\t0\n", k, x, x + 10 } }'
}

value() { awk -F '\t' -v q=influence_m -v s="$1" -v c="${2:-3}" '$1 == q && $2 == s { print $c }' statistics; }

# in_r EXPRESSION: its value, x being the influence distances.
in_r() {
  Rscript -e 'suppressMessages({library(nortest); library(boot)})' \
    -e 'x <- read.delim("rows.tsv", comment.char = "#")$influence_m' -e "cat(format($1, digits = 15), sep = '\n')"
}

@test "moments, intervals and distances of fits are R's" {
  rows >rows.tsv
  mcstats rows.tsv >statistics
  assert_near "$(value mean)" "$(in_r 'mean(x)')" 1e-12
  assert_near "$(value variance)" "$(in_r 'var(x)')" 1e-12
  assert_near "$(value mean 4)" "$(in_r 't.test(x)$conf.int[1]')" 1e-12
  assert_near "$(value mean 5)" "$(in_r 't.test(x)$conf.int[2]')" 1e-12
  assert_near "$(value skewness)" "$(in_r 'mean((x - mean(x))^3) / mean((x - mean(x))^2)^1.5')" 1e-12
  assert_near "$(value kurtosis)" "$(in_r 'mean((x - mean(x))^4) / mean((x - mean(x))^2)^2')" 1e-12
  assert_near "$(value quantile_0.25)" "$(in_r 'quantile(x, 0.25, type = 2)')" 1e-12
  assert_near "$(value normal_anderson_darling)" "$(in_r 'ad.test(x)$statistic')" 1e-10
  assert_near "$(value lognormal_lilliefors)" "$(in_r 'lillie.test(log(x))$statistic')" 1e-10
  assert_near "$(value normal_aic)" "$(in_r 'AIC(lm(x ~ 1))')" 1e-9
}

@test "simulated p values are those of nortest" {
  rows >rows.tsv
  mcstats rows.tsv --resamples 20000 >statistics
  # 10000 simulations scatter by 2 sqrt(p (1 - p) / 10000) <= 0.01; nortest's approximations are good to 0.01.
  assert_near "$(value normal_anderson_darling_p)" "$(in_r 'ad.test(x)$p.value')" 0.015
  assert_near "$(value normal_lilliefors_p)" "$(in_r 'lillie.test(x)$p.value')" 0.02
  assert_near "$(value lognormal_anderson_darling_p)" "$(in_r 'ad.test(log(x))$p.value')" 0.02
}

@test "bootstrap intervals are those of boot" {
  rows >rows.tsv
  mcstats rows.tsv --resamples 50000 >statistics
  in_r '{ set.seed(1); boot.ci(boot(x, function(d, i) mean(d[i]), 50000), type = "bca")$bca[4:5] }' >mean
  in_r '{ set.seed(1); boot.ci(boot(x, function(d, i) var(d[i]), 50000), type = "bca")$bca[4:5] }' >variance
  # Either side's ends scatter by some 1 % of the interval's width (1.1 and 7.5).
  assert_near "$(value bootstrap_mean 4)" "$(sed -n 1p mean)" 0.03
  assert_near "$(value bootstrap_mean 5)" "$(sed -n 2p mean)" 0.03
  assert_near "$(value bootstrap_variance 4)" "$(sed -n 1p variance)" 0.2
  assert_near "$(value bootstrap_variance 5)" "$(sed -n 2p variance)" 0.3
}

@test "exact bands are those of binom.test" {
  rows >rows.tsv
  zoning rows.tsv --curve >curve
  for distance in 9 11 14 17; do
    line=$(awk -F '\t' -v d=$distance '$1 == "influence_m" && $2 == d' curve)
    assert_near "$(cut -f 4 <<<"$line")" "$(in_r "binom.test(sum(x > $distance), 60)\$conf.int[1]")" 1e-10
    assert_near "$(cut -f 5 <<<"$line")" "$(in_r "binom.test(sum(x > $distance), 60)\$conf.int[2]")" 1e-10
  done
}

@test "intervals of pairs are those of their means" {
  pairs 30 >rows.tsv
  mcstats rows.tsv >statistics
  in_r 't.test(tapply(x, read.delim("rows.tsv", comment.char = "#")$block, mean))$conf.int' >mean
  assert_near "$(value mean 4)" "$(sed -n 1p mean)" 1e-12
  assert_near "$(value mean 5)" "$(sed -n 2p mean)" 1e-12
}

@test "differences by realization are those of paired tests, and rank intervals those of the binomial" {
  rows >rows.tsv
  rows | awk -F '\t' -v OFS='\t' '/^[0-9]/ { $3 += 0.3 + $1 % 7 / 10; $4 = $3 + 10 } { print }' >other.tsv
  mcstats other.tsv --against rows.tsv >statistics
  in_r '{ y <- read.delim("other.tsv", comment.char = "#")$influence_m; c(t.test(y, x, paired = TRUE)$conf.int, sd(y) / sd(x), cor(x, y)) }' >paired
  assert_near "$(value mean_difference 4)" "$(sed -n 1p paired)" 1e-11
  assert_near "$(value mean_difference 5)" "$(sed -n 2p paired)" 1e-11
  assert_near "$(value sd_ratio)" "$(sed -n 3p paired)" 1e-12
  assert_near "$(value correlation)" "$(sed -n 4p paired)" 1e-12
  mcstats rows.tsv >statistics
  # The highest rank r with P(B <= r - 1) <= 2.5 % and the lowest with P(B >= r) <= 2.5 %.
  in_r '{ s <- sort(x); c(s[max(which(pbinom(0:59, 60, 0.75) <= 0.025))], s[min(which(1 - pbinom(0:59, 60, 0.75) <= 0.025))]) }' >ranks
  assert_near "$(value quantile_0.75 4)" "$(sed -n 1p ranks)" 1e-12
  assert_near "$(value quantile_0.75 5)" "$(sed -n 2p ranks)" 1e-12
}
