// Confidence intervals: of a mean, a variance, a proportion, a quantile. An end that the sample cannot give is infinite.
//
// Two-sided, of confidence 1 - alpha, alpha/2 on either side; 95 % unless another is asked for. Values are taken as independent.
// - mean: m +- t_{n-1} s / sqrt(n) (Student). Exact for a Normal, otherwise by the central limit theorem.
// - variance: Bonett (2006), "Approximate confidence interval for standard deviation of nonnormal distributions", Comput. Stat.
//   Data Anal. 50, 775-782: ln(c s^2) +- z c sqrt((k - (n - 3) / n) / (n - 1)), c = n / (n - z), k the kurtosis about a trimmed
//   mean. The textbook interval by chi-square holds for a Normal alone: reach is bimodal, its variance scatters differently.
// - proportion: Clopper and Pearson (1934), exact: at least the stated confidence for every n and every true proportion. Wilson
//   (1927): shorter, right on average, for a single true proportion at times less. Simultaneous: of all proportions P(X > x) at once,
//   hits / n +- sqrt(ln(2 / alpha) / (2 n)) (Dvoretzky, Kiefer and Wolfowitz 1956 with the constant of Massart 1990).
// - quantile: order statistics, no distribution assumed: ranks r with P(B <= r - 1) <= alpha/2 and P(B >= r) <= alpha/2, B
//   binomial of n and p. At least the stated confidence; a rank that no sample of this size has gives an infinite end.
// A constant series says nothing of its spread: its mean and variance have no upper end, however many values it holds.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "stats/moments.hpp"

namespace slidezone {

inline constexpr double standard_confidence = 0.95;

struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// Infinite on both ends for fewer than 2 values and for equal ones.
Interval mean_interval(const Moments& moments, double confidence = standard_confidence);

/// Infinite above for fewer than 5 values and for equal ones. Needs the values again: its kurtosis is taken about a trimmed mean.
Interval variance_interval(std::span<const double> values, double confidence = standard_confidence);

/// Of `hits` among `count` > 0; fractions of runs where dependent ones count for fewer (blocks.hpp).
Interval clopper_pearson(double hits, double count, double confidence = standard_confidence);
Interval wilson(double hits, double count, double confidence = standard_confidence);
Interval simultaneous(double hits, double count, double confidence = standard_confidence);

/// The three by name: "exact", "wilson", "simultaneous".
enum class Band { exact, wilson, simultaneous };
Interval proportion_interval(Band band, double hits, double count, double confidence = standard_confidence);

/// Ranks (1 is the smallest of `count` values) whose order statistics enclose the quantile of probability p in (0, 1). `effective` is the
/// number of independent values that tell as much, at most `count` (blocks.hpp; Woodruff 1952): rank r of them is rank
/// r * count / effective, a fraction, of those that there are.
struct Ranks {
  std::optional<std::size_t> low;
  std::optional<std::size_t> high;
};
Ranks quantile_ranks(std::size_t count, double p, double effective, double confidence = standard_confidence);

/// The quantile of values in ascending order: the middle of all x with P(X <= x) = p in the sample, or the x where the sample steps
/// over p (type 2 of Hyndman and Fan 1996; the median as usually defined). nan for no values.
double quantile(std::span<const double> ascending, double p);

}  // namespace slidezone
