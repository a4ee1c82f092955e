#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/round_step.hpp"
#include "core/text.hpp"
#include "stats/distribution.hpp"
#include "summary/summary.hpp"

namespace slidezone {

// ---- running trace ----

static Interval running_sd_interval(const Moments& moments) {
  constexpr double z = 1.959963984540054;
  const double n = static_cast<double>(moments.count());
  const double spread = std::sqrt(std::max(0.0, moments.kurtosis() - (n - 3) / (n - 1)) / n);
  if (moments.count() < 5 || !(moments.variance() > 0)) return {0, std::numeric_limits<double>::infinity()};
  return {moments.standard_deviation() * std::exp(-z / 2 * spread), moments.standard_deviation() * std::exp(z / 2 * spread)};
}

namespace {

/// The runs so far.
struct Running {
  Moments moments;
  Blocks blocks;  // unused where runs are plain
  std::map<std::uint64_t, std::size_t> places;

  void add(const Observation& seen) {
    moments.add(seen.value);
    if (seen.block == 0) return;
    const std::size_t place = places.try_emplace(seen.block, blocks.size()).first->second;
    if (place == blocks.size()) blocks.emplace_back();
    blocks[place].push_back(seen.value);
  }
  Interval of_mean() const { return blocks.empty() ? mean_interval(moments) : mean_interval(blocks); }
  Interval of_sd() const {
    return blocks.empty() ? running_sd_interval(moments) : root({moments.variance(), variance_interval(blocks, 0)}).interval;
  }
};

}  // namespace

static void add_trace(Table& table, const ReachOfStudy& reach) {
  Running running;
  const Moments& moments = running.moments;
  for (const Observation& seen : reach.sample) {
    if (seen.knowledge == Knowledge::unknown) continue;
    const double mean = moments.mean();
    const double variance = moments.variance();
    running.add(seen);
    const Interval of_mean = running.of_mean();
    const Interval of_sd = running.of_sd();
    table.add_row({reach.quantity, std::to_string(moments.count()), format_real(moments.mean()), format_limit(of_mean.low),
                   format_limit(of_mean.high), format_real(moments.standard_deviation()), format_limit(of_sd.low), format_limit(of_sd.high),
                   format_real(moments.mean() - mean), format_real(moments.variance() - variance)});
  }
}

Table trace_table(const Ensemble& ensemble) {
  Table table({"quantity", "n", "mean_m", "mean_low_m", "mean_high_m", "sd_m", "sd_low_m", "sd_high_m", "change_of_mean_m",
               "change_of_variance_m2"});
  for (const ReachOfStudy* reach : {&ensemble.influence, &ensemble.runout}) add_trace(table, *reach);
  return table;
}

// ---- histogram ----

/// Width of the bins; 1 m where all values are equal.
static RoundStep bin_width(std::span<const double> ascending) {
  const double spread = quantile(ascending, 0.75) - quantile(ascending, 0.25);
  const double width = 2 * spread / std::cbrt(static_cast<double>(ascending.size()));
  const double range = ascending.back() - ascending.front();
  const double wanted = width > 0 ? std::max(width, range / 500) : range / 10;  // half of the values may be equal
  return round_step(wanted > 0 ? 1.5 * wanted : 1);
}

static void add_histogram(Table& table, const ReachOfStudy& reach) {
  std::vector<double> values = known_values(reach.slides);
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  const RoundStep width = bin_width(values);
  auto next = values.begin();
  for (double bin = std::floor(values.front() / width.multiple(1)); next != values.end(); ++bin) {
    const auto first = next;
    next = std::find_if(next, values.end(), [&](double value) { return value >= width.multiple(bin + 1); });
    const double count = static_cast<double>(next - first);
    table.add_row({reach.quantity, format_real(width.multiple(bin)), format_real(width.multiple(bin + 1)), std::to_string(next - first),
                   format_real(count / static_cast<double>(values.size()) / width.multiple(1))});
  }
}

Table histogram_table(const Ensemble& ensemble) {
  Table table({"quantity", "low_m", "high_m", "count", "density"});
  for (const ReachOfStudy* reach : {&ensemble.influence, &ensemble.runout}) add_histogram(table, *reach);
  return table;
}

// ---- densities ----

static void add_densities(Table& table, const ReachOfStudy& reach) {
  std::vector<double> values = known_values(reach.slides);
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  std::vector<std::optional<Fit>> fits;
  for (const Family family : families) fits.push_back(fit_of(family, values));
  const double range = values.back() > values.front() ? values.back() - values.front() : 1;
  constexpr int steps = 400;
  for (int i = 0; i <= steps; ++i) {
    const double x = values.front() - range / 4 + 1.5 * range * i / steps;
    const auto below = std::upper_bound(values.begin(), values.end(), x) - values.begin();
    std::vector<std::string> fields = {reach.quantity, format_real(x),
                                       format_real(static_cast<double>(below) / static_cast<double>(values.size()))};
    for (const std::optional<Fit>& fit : fits) {
      fields.push_back(fit ? format_real(density(*fit, x)) : "nan");
      fields.push_back(fit ? format_real(cumulative(*fit, x)) : "nan");
    }
    table.add_row(std::move(fields));
  }
}

Table density_table(const Ensemble& ensemble) {
  std::vector<std::string> columns = {"quantity", "distance_m", "empirical_cumulative"};
  for (const Family family : families) columns.insert(columns.end(), {name_of(family) + "_density", name_of(family) + "_cumulative"});
  Table table(columns);
  for (const ReachOfStudy* reach : {&ensemble.influence, &ensemble.runout}) add_densities(table, *reach);
  return table;
}

}  // namespace slidezone
