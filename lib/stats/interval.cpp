#include "stats/interval.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "stats/gsl_errors.hpp"

namespace slidezone {

/// The Normal quantile that cuts alpha/2 off above.
static double normal_limit(double confidence) { return gsl_cdf_ugaussian_Qinv((1 - confidence) / 2); }

Interval mean_interval(const Moments& moments, double confidence) {
  if (!(moments.variance() > 0)) return {};
  const double n = static_cast<double>(moments.count());
  const double half_width = gsl_cdf_tdist_Qinv((1 - confidence) / 2, n - 1) * moments.standard_deviation() / std::sqrt(n);
  return {moments.mean() - half_width, moments.mean() + half_width};
}

/// Mean without the share `trim` of the values at either end.
static double trimmed_mean(std::span<const double> values, double trim) {
  std::vector<double> ascending(values.begin(), values.end());
  std::sort(ascending.begin(), ascending.end());
  const auto cut = static_cast<std::ptrdiff_t>(trim * static_cast<double>(values.size()));
  return moments_of(std::span(ascending.begin() + cut, ascending.end() - cut)).mean();
}

/// n sum (x - centre)^4 / (sum (x - mean)^2)^2.
static double kurtosis_about(std::span<const double> values, double centre, double variance) {
  const double n = static_cast<double>(values.size());
  const double fourth =
      std::accumulate(values.begin(), values.end(), 0.0, [&](double sum, double x) { return sum + std::pow(x - centre, 4); });
  return n * fourth / std::pow((n - 1) * variance, 2);
}

Interval variance_interval(std::span<const double> values, double confidence) {
  const double n = static_cast<double>(values.size());
  const double variance = moments_of(values).variance();
  const double z = normal_limit(confidence);
  if (n <= 4 || n <= z || !(variance > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double trim = 1 / (2 * std::sqrt(n - 4));
  const double kurtosis = kurtosis_about(values, trimmed_mean(values, trim), variance);
  const double c = n / (n - z);
  const double half_width = z * c * std::sqrt(std::max(0.0, kurtosis - (n - 3) / n) / (n - 1));
  return {c * variance * std::exp(-half_width), c * variance * std::exp(half_width)};
}

Interval clopper_pearson(double hits, double count, double confidence) {
  assert(hits <= count && count > 0);
  keep_gsl_from_aborting();
  const double tail = (1 - confidence) / 2;
  return {hits == 0 ? 0 : gsl_cdf_beta_Pinv(tail, hits, count - hits + 1),
          hits == count ? 1 : gsl_cdf_beta_Qinv(tail, hits + 1, count - hits)};
}

Interval wilson(double hits, double count, double confidence) {
  assert(hits <= count && count > 0);
  const double z2 = std::pow(normal_limit(confidence), 2);
  const double p = hits / count;
  const double centre = (p + z2 / (2 * count)) / (1 + z2 / count);
  const double half_width = std::sqrt(z2 * (p * (1 - p) / count + z2 / (4 * count * count))) / (1 + z2 / count);
  return {hits == 0 ? 0 : centre - half_width, hits == count ? 1 : centre + half_width};
}

Interval simultaneous(double hits, double count, double confidence) {
  assert(hits <= count && count > 0);
  const double p = hits / count;
  const double half_width = std::sqrt(std::log(2 / (1 - confidence)) / (2 * count));
  return {std::max(p - half_width, 0.0), std::min(p + half_width, 1.0)};
}

Interval proportion_interval(Band band, double hits, double count, double confidence) {
  switch (band) {
    case Band::exact:
      return clopper_pearson(hits, count, confidence);
    case Band::wilson:
      return wilson(hits, count, confidence);
    case Band::simultaneous:
      return simultaneous(hits, count, confidence);
  }
  return {0, 1};
}

Ranks quantile_ranks(std::size_t count, double p, double effective, double confidence) {
  assert(p > 0 && p < 1 && effective <= static_cast<double>(count));
  if (effective <= 0) return {};
  keep_gsl_from_aborting();
  const double tail = (1 - confidence) / 2;
  const double part = effective / static_cast<double>(count);
  std::vector<std::size_t> ranks(count);
  std::iota(ranks.begin(), ranks.end(), std::size_t{1});
  // P(B <= r - 1) = I_{1-p}(n - r + 1, r) grows with r and P(B >= r) = I_p(r, n - r + 1) falls: either condition parts the ranks in two.
  const auto at_most = [&](std::size_t r) {
    const double rank = part * static_cast<double>(r);
    return gsl_cdf_beta_P(1 - p, effective - rank + 1, rank);
  };
  const auto above_low = std::partition_point(ranks.begin(), ranks.end(), [&](std::size_t r) { return at_most(r) <= tail; });
  const auto high = std::partition_point(ranks.begin(), ranks.end(), [&](std::size_t r) { return 1 - at_most(r) > tail; });
  Ranks result;
  if (above_low != ranks.begin()) result.low = *(above_low - 1);
  if (high != ranks.end()) result.high = *high;
  return result;
}

double quantile(std::span<const double> ascending, double p) {
  if (ascending.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double n = static_cast<double>(ascending.size());
  const double place = n * p;
  const double nearest = std::round(place);
  const auto value = [&](double rank) { return ascending[static_cast<std::size_t>(std::clamp(rank, 1.0, n)) - 1]; };
  if (std::abs(place - nearest) > 1e-9 * n) return value(std::ceil(place));  // n * p is whole but for rounding, or it is not
  const double low = value(nearest);
  const double high = value(nearest + 1);
  return std::isinf(high) ? high : low + (high - low) / 2;
}

}  // namespace slidezone
