#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "stats/distribution.hpp"
#include "stats/goodness.hpp"
#include "summary/summary.hpp"

namespace slidezone {

static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
static constexpr double infinity = std::numeric_limits<double>::infinity();
static constexpr Interval no_interval{nan, nan};
static constexpr std::array quantiles = {0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99};

namespace {

/// The rows of the table, one statistic each.
class Statistics {
 public:
  void add(const std::string& quantity, const std::string& statistic, const Estimate& estimate, std::size_t n) {
    table_.add_row({quantity, statistic, format_real(estimate.value), format_limit(estimate.interval.low),
                    format_limit(estimate.interval.high), std::to_string(n)});
  }
  void add(const std::string& quantity, const std::string& statistic, double value, std::size_t n) {
    add(quantity, statistic, {value, no_interval}, n);
  }
  const Table& table() const { return table_; }

 private:
  Table table_{{"quantity", "statistic", "value", "ci_low", "ci_high", "n"}};
};

}  // namespace

static void add_runs(Statistics& statistics, std::span<const Row> rows, const Ensemble& ensemble, std::size_t least_runs) {
  const std::size_t total = ensemble.failure.size();
  const BlockCount blocks = block_count(rows);
  statistics.add("runs", "total", static_cast<double>(total), total);
  statistics.add("runs", "blocks", static_cast<double>(blocks.blocks), total);
  for (const Status status : {Status::slid, Status::stable, Status::left_domain, Status::diverged})
    statistics.add("runs", to_string(status), static_cast<double>(count_of(rows, status)), total);
  statistics.add("runs", "probability_of_failure", failure_probability(ensemble), total);
  const std::size_t look = next_look(total, least_runs);
  statistics.add("runs", "next_look", static_cast<double>((look + blocks.size - 1) / blocks.size * blocks.size), total);
}

/// Of a variance, with the kurtosis: var(s^2) = s^4 (b_2 - (n - 3) / (n - 1)) / n.
static double plain_variance_error(const Moments& moments) {
  const double n = static_cast<double>(moments.count());
  return moments.variance() * std::sqrt(std::max(moments.kurtosis() - (n - 3) / (n - 1), 0.0) / n);
}

/// Of mean, variance and sd.
static std::vector<std::pair<std::string, double>> standard_errors(const Sample& sample, const Moments& moments) {
  const Blocks blocks = known_blocks(sample);
  const double of_variance = has_blocks(sample) ? variance_error(blocks) : plain_variance_error(moments);
  return {{"mean", mean_error(blocks)}, {"variance", of_variance}, {"sd", of_variance / (2 * moments.standard_deviation())}};
}

/// What equal values do not tell is nan.
static void add_moments(Statistics& statistics, const ReachOfStudy& reach, const Resampling& resampling) {
  const Moments moments = moments_of(known_values(reach.sample));
  const bool has_spread = moments.variance() > 0;
  const bool is_complete = count_of(reach.sample, Knowledge::at_least) == 0;
  const MomentIntervals resampled =
      is_complete ? bootstrap_intervals(known_blocks(reach.sample), reach.quantity, resampling) : MomentIntervals{};
  const Estimate variance = variance_estimate(reach.sample);
  const std::size_t n = moments.count();
  const auto add = [&](const std::string& name, const Estimate& estimate) { statistics.add(reach.quantity, name, estimate, n); };
  const auto add_of_spread = [&](const std::string& name, const Estimate& estimate) {
    add(name, has_spread ? estimate : Estimate{nan, no_interval});
  };
  add("mean", mean_estimate(reach.sample));
  add_of_spread("variance", variance);
  add_of_spread("sd", root(variance));
  add_of_spread("skewness", {moments.skewness(), resampled.skewness});
  add_of_spread("kurtosis", {moments.kurtosis(), resampled.kurtosis});
  add("min", {moments.minimum(), no_interval});
  add("max", {moments.maximum(), no_interval});
  for (const auto& [name, error] : standard_errors(reach.sample, moments)) add_of_spread("standard_error_of_" + name, {error, no_interval});
  add_of_spread("bootstrap_mean", {moments.mean(), resampled.mean});
  add_of_spread("bootstrap_variance", {moments.variance(), resampled.variance});
  add_of_spread("bootstrap_sd", root({moments.variance(), resampled.variance}));
}

static void add_quantiles(Statistics& statistics, const ReachOfStudy& reach) {
  for (const double p : quantiles)
    statistics.add(reach.quantity, "quantile_" + format_real(p), quantile_estimate(reach.sample, p), reach.sample.size());
}

static void add_deterministic(Statistics& statistics, const ReachOfStudy& reach) {
  if (!reach.deterministic) return;
  statistics.add(reach.quantity, "deterministic", *reach.deterministic, 1);
  const double next_below = std::nextafter(*reach.deterministic, -infinity);
  statistics.add(reach.quantity, "exceeds_deterministic", exceedance_estimate(reach.sample, *reach.deterministic), reach.sample.size());
  statistics.add(reach.quantity, "reaches_deterministic", exceedance_estimate(reach.sample, next_below), reach.sample.size());
}

// ---- fits ----

/// Simulated distances of the families that have one law for all members; both quantities have as many slides, so one set serves both.
using Simulations = std::map<Family, NullDistances>;

static Simulations shared_simulations(std::size_t count, const Resampling& resampling) {
  Simulations simulations;
  for (const Family family : {Family::normal, Family::weibull}) {
    auto simulated = simulated_distances({family, {}}, count, resampling.resamples / 2, resampling.seed);
    if (simulated) simulations.emplace(family, *std::move(simulated));
  }
  if (const auto normal = simulations.find(Family::normal); normal != simulations.end())
    simulations.emplace(Family::lognormal, normal->second);  // the same law, in ln x
  return simulations;
}

static DistanceP p_values_of(const Fit& fit, const Distances& found, std::size_t count, const Simulations& shared,
                             const Resampling& resampling) {
  if (!has_one_law(fit.family)) {
    const auto own = simulated_distances(fit, count, resampling.resamples / 8, resampling.seed);
    return own ? p_values(found, count, *own) : DistanceP{nan, nan};
  }
  const auto simulated = shared.find(fit.family);
  return simulated == shared.end() ? DistanceP{nan, nan} : p_values(found, count, simulated->second);
}

static void add_parameters(Statistics& statistics, const ReachOfStudy& reach, Family family, const std::optional<Fit>& fit) {
  const std::vector<std::string>& names = parameter_names(family);
  const auto intervals = fit ? parameter_intervals(family, reach.slides) : std::nullopt;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Estimate parameter{fit ? fit->parameters[i] : nan, intervals ? (*intervals)[i] : no_interval};
    statistics.add(reach.quantity, name_of(family) + "_" + names[i], parameter, reach.slides.size());
  }
}

static void add_goodness(Statistics& statistics, const ReachOfStudy& reach, Family family, const std::optional<Fit>& fit,
                         const Simulations& simulations, const Resampling& resampling) {
  const std::vector<double> values = known_values(reach.slides);
  const bool is_independent = !has_blocks(reach.slides);  // what p values are of
  const auto add = [&](const std::string& what, double value) {
    statistics.add(reach.quantity, name_of(family) + "_" + what, value, values.size());
  };
  const auto binned = fit ? chi_square(*fit, values) : std::nullopt;
  add("chi_square", binned ? binned->statistic : nan);
  add("chi_square_bins", binned ? static_cast<double>(binned->bins) : nan);
  add("chi_square_degrees_of_freedom", binned ? static_cast<double>(binned->degrees_of_freedom) : nan);
  add("chi_square_p", binned && is_independent ? binned->p : nan);
  const Distances found = fit ? distances(*fit, values) : Distances{nan, nan};
  const DistanceP p = fit && is_independent ? p_values_of(*fit, found, values.size(), simulations, resampling) : DistanceP{nan, nan};
  const bool is_possible = std::isfinite(found.anderson_darling);
  add("anderson_darling", is_possible ? found.anderson_darling : nan);
  add("anderson_darling_p", p.anderson_darling);
  add("lilliefors", found.lilliefors);
  add("lilliefors_p", p.lilliefors);
  add("aic", fit ? akaike_criterion(*fit, values) : nan);
}

static void add_slides(Statistics& statistics, const ReachOfStudy& reach, const Simulations& simulations, const Resampling& resampling) {
  statistics.add(reach.quantity, "mean_of_slides", mean_estimate(reach.slides), reach.slides.size());
  statistics.add(reach.quantity, "sd_of_slides", root(variance_estimate(reach.slides)), reach.slides.size());
  for (const Family family : families) {
    const std::optional<Fit> fit = fit_of(family, known_values(reach.slides));
    add_parameters(statistics, reach, family, fit);
    add_goodness(statistics, reach, family, fit, simulations, resampling);
  }
}

// ---- verdicts ----

static void add_paper_verdict(Statistics& statistics, const ReachOfStudy& reach) {
  const std::vector<double> values = known_values(reach.sample);
  const PaperVerdict verdict = paper_verdict(values);
  const auto add = [&](const std::string& what, double value) { statistics.add(reach.quantity, what, value, values.size()); };
  add("stop:paper", verdict.is_met ? 1 : 0);
  add("paper_change_of_mean", verdict.change_of_mean);
  add("paper_change_of_variance", verdict.change_of_variance);
  add("paper_first_met", verdict.first_met ? static_cast<double>(*verdict.first_met) : nan);
}

static void add_width_verdict(Statistics& statistics, const ReachOfStudy& reach, const StopRule& rule, std::size_t least_runs) {
  const std::size_t n = reach.sample.size();
  const double found = half_width(rule, reach.sample);
  const Interval interval = found < infinity ? target_interval(rule, reach.sample) : no_interval;
  const double needed = std::ceil(static_cast<double>(n) * std::pow(found / rule.half_width, 2));
  const std::string text = to_string(rule);
  statistics.add(reach.quantity, "stop:" + text, found <= rule.half_width && n >= least_runs ? 1 : 0, n);
  statistics.add(reach.quantity, "half_width:" + text, {std::isfinite(found) ? found : nan, interval}, n);
  statistics.add(reach.quantity, "runs_needed:" + text, std::isfinite(found) ? needed : nan, n);
}

static void add_verdicts(Statistics& statistics, const ReachOfStudy& reach, const SummaryOptions& options) {
  for (const StopRule& rule : options.rules) {
    if (!rule.quantity.empty() && rule.quantity != reach.quantity) continue;
    if (rule.kind == StopRule::Kind::paper) {
      add_paper_verdict(statistics, reach);
    } else {
      add_width_verdict(statistics, reach, rule, options.least_runs);
    }
  }
}

Table statistics_table(std::span<const Row> rows, const Ensemble& ensemble, const SummaryOptions& options) {
  Statistics statistics;
  add_runs(statistics, rows, ensemble, options.least_runs);
  const Simulations simulations = shared_simulations(ensemble.influence.slides.size(), options.resampling);
  for (const ReachOfStudy* reach : {&ensemble.influence, &ensemble.runout}) {
    add_moments(statistics, *reach, options.resampling);
    add_quantiles(statistics, *reach);
    add_deterministic(statistics, *reach);
    add_slides(statistics, *reach, simulations, options.resampling);
    add_verdicts(statistics, *reach, options);
  }
  return statistics.table();
}

}  // namespace slidezone
