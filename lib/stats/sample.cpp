#include "stats/sample.hpp"

#include <algorithm>
#include <cmath>

namespace slidezone {

static constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t count_of(const Sample& sample, Knowledge knowledge) {
  return static_cast<std::size_t>(
      std::count_if(sample.begin(), sample.end(), [&](const Observation& seen) { return seen.knowledge == knowledge; }));
}

std::vector<double> known_values(const Sample& sample) {
  std::vector<double> values;
  for (const Observation& seen : sample) {
    if (seen.knowledge != Knowledge::unknown) values.push_back(seen.value);
  }
  return values;
}

static double lowest(const Observation& seen) { return seen.knowledge == Knowledge::unknown ? -infinity : seen.value; }

static double highest(const Observation& seen) { return seen.knowledge == Knowledge::exact ? seen.value : infinity; }

static std::vector<double> ascending(const Sample& sample, double (*reading)(const Observation&)) {
  std::vector<double> values;
  for (const Observation& seen : sample) values.push_back(reading(seen));
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<double> lowest_values(const Sample& sample) { return ascending(sample, lowest); }

std::vector<double> highest_values(const Sample& sample) { return ascending(sample, highest); }

Estimate quantile_estimate(const Sample& sample, double p, double confidence) {
  std::vector<double> known = known_values(sample);
  std::sort(known.begin(), known.end());
  const Ranks ranks = quantile_ranks(sample.size(), p, confidence);
  Estimate estimate{quantile(known, p), {}};
  if (ranks.low) estimate.interval.low = lowest_values(sample)[*ranks.low - 1];
  if (ranks.high) estimate.interval.high = highest_values(sample)[*ranks.high - 1];
  return estimate;
}

Estimate exceedance_estimate(const Sample& sample, double x, Band band, double confidence) {
  std::size_t exceeding = 0;
  std::size_t doubtful = 0;
  for (const Observation& seen : sample) {
    if (lowest(seen) > x) {
      ++exceeding;
    } else if (highest(seen) > x) {
      ++doubtful;
    }
  }
  if (sample.empty()) return {std::numeric_limits<double>::quiet_NaN(), {0, 1}};
  const double decided = static_cast<double>(sample.size() - doubtful);
  return {decided > 0 ? static_cast<double>(exceeding) / decided : std::numeric_limits<double>::quiet_NaN(),
          {proportion_interval(band, exceeding, sample.size(), confidence).low,
           proportion_interval(band, exceeding + doubtful, sample.size(), confidence).high}};
}

Estimate mean_estimate(const Sample& sample, double confidence) {
  const Moments moments = moments_of(known_values(sample));
  Estimate estimate{moments.mean(), mean_interval(moments, confidence)};
  if (count_of(sample, Knowledge::at_least) > 0) estimate.interval.high = infinity;
  return estimate;
}

Estimate variance_estimate(const Sample& sample, double confidence) {
  const std::vector<double> known = known_values(sample);
  Estimate estimate{moments_of(known).variance(), variance_interval(known, confidence)};
  if (count_of(sample, Knowledge::at_least) > 0) estimate.interval = {0, infinity};
  return estimate;
}

Estimate root(const Estimate& estimate) {
  return {std::sqrt(estimate.value), {std::sqrt(std::max(estimate.interval.low, 0.0)), std::sqrt(estimate.interval.high)}};
}

}  // namespace slidezone
