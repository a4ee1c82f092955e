#include "stats/bootstrap.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "core/random.hpp"

namespace slidezone {

namespace {

/// Sums of the first four powers of a value less the mean of the whole sample: all four statistics follow from them.
struct PowerSums {
  double count = 0;
  std::array<double, 4> sums{};
};

using Statistics = std::array<double, 4>;  // mean less that of the whole sample, variance, skewness, kurtosis

PowerSums operator+(PowerSums sums, const PowerSums& more) {
  sums.count += more.count;
  for (std::size_t k = 0; k < 4; ++k) sums.sums[k] += more.sums[k];
  return sums;
}

PowerSums operator-(PowerSums sums, const PowerSums& less) {
  sums.count -= less.count;
  for (std::size_t k = 0; k < 4; ++k) sums.sums[k] -= less.sums[k];
  return sums;
}

}  // namespace

/// Central moments from raw ones.
static Statistics statistics_of(const PowerSums& sums) {
  const double n = sums.count;
  const double m = sums.sums[0] / n;
  const double r2 = sums.sums[1] / n, r3 = sums.sums[2] / n, r4 = sums.sums[3] / n;
  const double m2 = std::max(0.0, r2 - m * m);
  const double m3 = r3 - 3 * m * r2 + 2 * m * m * m;
  const double m4 = r4 - 4 * m * r3 + 6 * m * m * r2 - 3 * m * m * m * m;
  if (m2 == 0) return {m, 0, 0, 0};  // a resample of one value only
  return {m, m2 * n / (n - 1), m3 / std::pow(m2, 1.5), m4 / (m2 * m2)};
}

/// Of each block.
static std::vector<PowerSums> powers_of(const Blocks& blocks, double mean) {
  std::vector<PowerSums> powers;
  for (const auto& block : blocks) {
    powers.emplace_back();
    for (const double value : block) {
      const double d = value - mean;
      powers.back() = powers.back() + PowerSums{1, {d, d * d, d * d * d, d * d * d * d}};
    }
  }
  return powers;
}

static std::vector<Statistics> resampled_statistics(const std::vector<PowerSums>& powers, std::string_view name,
                                                    const Resampling& resampling) {
  std::vector<Statistics> statistics;
  std::vector<std::uint64_t> words(powers.size());
  const std::uint32_t stream = purpose("bootstrap of " + std::string(name));
  for (std::uint32_t k = 1; k <= resampling.resamples; ++k) {
    fill_words(words, {resampling.seed, stream, k});
    PowerSums sums;
    for (const std::uint64_t word : words) sums = sums + powers[(word >> 32) * powers.size() >> 32];
    statistics.push_back(statistics_of(sums));
  }
  return statistics;
}

/// The acceleration of each statistic.
static Statistics accelerations(const std::vector<PowerSums>& powers, const PowerSums& whole) {
  std::vector<Statistics> without;
  Statistics means{};
  for (const PowerSums& power : powers) {
    without.push_back(statistics_of(whole - power));
    for (std::size_t s = 0; s < 4; ++s) means[s] += without.back()[s] / static_cast<double>(powers.size());
  }
  Statistics result{};
  for (std::size_t s = 0; s < 4; ++s) {
    double squares = 0, cubes = 0;
    for (const Statistics& left : without) {
      const double d = means[s] - left[s];
      squares += d * d;
      cubes += d * d * d;
    }
    result[s] = squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
  }
  return result;
}

/// The quantile of ascending values by linear interpolation between ranks p (n + 1), as Davison and Hinkley (1997, 2.4) advise.
static double resampled_quantile(std::span<const double> ascending, double p) {
  const double n = static_cast<double>(ascending.size());
  const double rank = std::clamp(p * (n + 1), 1.0, n);
  const auto low = static_cast<std::size_t>(rank);
  if (low >= ascending.size()) return ascending.back();
  return std::lerp(ascending[low - 1], ascending[low], rank - std::floor(rank));
}

static Interval bca_interval(std::vector<double> resampled, double found, double acceleration, double confidence) {
  std::sort(resampled.begin(), resampled.end());
  const double rounding = 1e-12 * (resampled.back() - resampled.front());  // ties are those of exact arithmetic
  const auto first = std::lower_bound(resampled.begin(), resampled.end(), found - rounding);
  const auto last = std::upper_bound(resampled.begin(), resampled.end(), found + rounding);
  const double below = static_cast<double>(first - resampled.begin()) + static_cast<double>(last - first) / 2;
  const double share = below / static_cast<double>(resampled.size());
  if (share <= 0 || share >= 1) return {};
  const double z0 = gsl_cdf_ugaussian_Pinv(share);
  const double z = gsl_cdf_ugaussian_Qinv((1 - confidence) / 2);
  const auto end = [&](double side) {
    return resampled_quantile(resampled, gsl_cdf_ugaussian_P(z0 + (z0 + side) / (1 - acceleration * (z0 + side))));
  };
  return {end(-z), end(z)};
}

MomentIntervals bootstrap_intervals(const Blocks& blocks, std::string_view name, const Resampling& resampling, double confidence) {
  const Moments moments = moments_of_all(blocks);
  if (blocks.size() < 8 || !(moments.variance() > 0)) return {};
  const auto powers = powers_of(blocks, moments.mean());
  const PowerSums whole = std::accumulate(powers.begin(), powers.end(), PowerSums{});
  const Statistics found = statistics_of(whole);
  const Statistics acceleration = accelerations(powers, whole);
  const std::vector<Statistics> resampled = resampled_statistics(powers, name, resampling);
  const auto interval = [&](std::size_t s) {
    std::vector<double> column;
    for (const Statistics& one : resampled) column.push_back(one[s]);
    return bca_interval(std::move(column), found[s], acceleration[s], confidence);
  };
  const Interval mean = interval(0);
  return {{moments.mean() + mean.low, moments.mean() + mean.high}, interval(1), interval(2), interval(3)};
}

}  // namespace slidezone
