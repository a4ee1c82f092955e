#include "stats/sample.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace slidezone {

static constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t count_of(const Sample& sample, Knowledge knowledge) {
  return static_cast<std::size_t>(
      std::count_if(sample.begin(), sample.end(), [&](const Observation& seen) { return seen.knowledge == knowledge; }));
}

static bool is_known(const Observation& seen) { return seen.knowledge != Knowledge::unknown; }

std::vector<double> known_values(const Sample& sample) {
  std::vector<double> values;
  for (const Observation& seen : sample) {
    if (is_known(seen)) values.push_back(seen.value);
  }
  return values;
}

bool has_blocks(const Sample& sample) {
  return std::any_of(sample.begin(), sample.end(), [](const Observation& seen) { return seen.block != 0; });
}

/// `value_of` each observation that `is_wanted`, by block.
static Blocks blocks_of(const Sample& sample, const std::function<double(const Observation&)>& value_of,
                        const std::function<bool(const Observation&)>& is_wanted) {
  Blocks blocks;
  std::map<std::uint64_t, std::size_t> places;
  for (const Observation& seen : sample) {
    if (!is_wanted(seen)) continue;
    const auto place = seen.block == 0 ? places.end() : places.try_emplace(seen.block, blocks.size()).first;
    const std::size_t index = place == places.end() ? blocks.size() : place->second;
    if (index == blocks.size()) blocks.emplace_back();
    blocks[index].push_back(value_of(seen));
  }
  return blocks;
}

Blocks known_blocks(const Sample& sample) {
  return blocks_of(
      sample, [](const Observation& seen) { return seen.value; }, is_known);
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

/// The number of independent runs that tell as much of the share of those that are `counted`.
static double effective_count_of(const Sample& sample, const std::function<bool(const Observation&)>& is_counted, double confidence) {
  if (!has_blocks(sample)) return static_cast<double>(sample.size());
  const auto value = [&](const Observation& seen) { return is_counted(seen) ? 1.0 : 0.0; };
  return effective_count(blocks_of(sample, value, [](const Observation&) { return true; }), confidence);
}

Estimate quantile_estimate(const Sample& sample, double p, double confidence) {
  std::vector<double> known = known_values(sample);
  std::sort(known.begin(), known.end());
  Estimate estimate{quantile(known, p), {}};
  const auto is_below = [&](const Observation& seen) { return lowest(seen) <= estimate.value; };
  const Ranks ranks = quantile_ranks(sample.size(), p, effective_count_of(sample, is_below, confidence), confidence);
  if (ranks.low) estimate.interval.low = lowest_values(sample)[*ranks.low - 1];
  if (ranks.high) estimate.interval.high = highest_values(sample)[*ranks.high - 1];
  return estimate;
}

/// The interval of the share of the runs that are counted.
static Interval share_interval(const Sample& sample, const std::function<bool(const Observation&)>& is_counted, Band band,
                               double confidence) {
  const double hits = static_cast<double>(std::count_if(sample.begin(), sample.end(), is_counted));
  const double effective = effective_count_of(sample, is_counted, confidence);
  if (effective <= 0) return {0, 1};
  return proportion_interval(band, hits * (effective / static_cast<double>(sample.size())), effective, confidence);
}

Estimate exceedance_estimate(const Sample& sample, double x, Band band, double confidence) {
  const auto surely = [x](const Observation& seen) { return lowest(seen) > x; };
  const auto perhaps = [x](const Observation& seen) { return highest(seen) > x; };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (sample.empty()) return {nan, {0, 1}};
  const auto exceeding = std::count_if(sample.begin(), sample.end(), surely);
  const auto doubtful = std::count_if(sample.begin(), sample.end(), perhaps) - exceeding;
  const double decided = static_cast<double>(std::ssize(sample) - doubtful);
  return {decided > 0 ? static_cast<double>(exceeding) / decided : nan,
          {share_interval(sample, surely, band, confidence).low, share_interval(sample, perhaps, band, confidence).high}};
}

Estimate mean_estimate(const Sample& sample, double confidence) {
  const Moments moments = moments_of(known_values(sample));
  Estimate estimate{moments.mean(),
                    has_blocks(sample) ? mean_interval(known_blocks(sample), confidence) : mean_interval(moments, confidence)};
  if (count_of(sample, Knowledge::at_least) > 0) estimate.interval.high = infinity;
  return estimate;
}

/// A variance with this interval, or with none where censored values leave it open.
static Estimate variance_with(const Sample& sample, const Interval& interval) {
  if (count_of(sample, Knowledge::at_least) > 0) return {moments_of(known_values(sample)).variance(), {0, infinity}};
  return {moments_of(known_values(sample)).variance(), interval};
}

Estimate variance_estimate(const Sample& sample, double confidence) {
  if (has_blocks(sample)) return variance_with(sample, variance_interval(known_blocks(sample), 0, confidence));
  return variance_with(sample, variance_interval(known_values(sample), confidence));
}

Estimate guarded_variance_estimate(const Sample& sample, double confidence) {
  return variance_with(sample, variance_interval(known_blocks(sample), 2, confidence));
}

Estimate root(const Estimate& estimate) {
  return {std::sqrt(estimate.value), {std::sqrt(std::max(estimate.interval.low, 0.0)), std::sqrt(estimate.interval.high)}};
}

}  // namespace slidezone
