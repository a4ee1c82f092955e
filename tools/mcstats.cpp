// mcstats: what the realizations of a study say of influence and runout distance, and how well.
// Rows ("slidezone-row 1") -> one table of statistics ("slidezone-statistics 1").
//   cat rows/*.tsv | mcstats --stop mean=0.2
#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/provenance.hpp"
#include "core/text.hpp"
#include "core/tool.hpp"
#include "ensemble/ensemble.hpp"
#include "io/file.hpp"
#include "io/table.hpp"
#include "rows/row.hpp"
#include "stats/distribution.hpp"
#include "stats/stopping.hpp"

namespace slidezone {
namespace {

struct Options {
  std::vector<std::string> rows = {"-"};
  std::vector<std::string> stop = {"paper", "mean=0.2"};
  std::string output = "-";
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Interval no_interval{nan, nan};
constexpr double quantiles[] = {0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99};

const char* const manual =
    R"(Moments, quantiles, distribution fits and convergence of the influence distance (influence_m) and the runout distance (runout_m).

Columns of the result: quantity, statistic, value, ci_low and ci_high (95 % interval), n (number of values that went in). A value or
interval that does not exist is nan; an end that the sample cannot give is "unbounded". Distances in m, variances in m2.
  runs        count by status: total, slid, stable, left_domain, diverged; probability_of_failure
  mean variance sd min max quantile_P
              of all runs, failed or not. A stable run counts with the reach that it has. A run that left the grid counts with the
              reach it had: means and quantiles are then lower bounds and lose their upper end. Diverged runs are left out of moments;
              intervals of quantiles and probabilities allow for any reach of theirs
  exceeds_deterministic
              P(reach > that of realization 0), where the rows hold it; realization 0 enters nothing else
  mean_of_slides sd_of_slides, normal_*, lognormal_*
              given failure: of the runs that slid and stayed in the grid. Parameters with intervals; chi_square, its bins, its degrees
              of freedom and its p value. A large p from few runs says little
  stop:RULE   1 where the rule is met, else 0
  paper_change_of_mean paper_change_of_variance paper_first_met
              by the last run; the number of runs after which the paper's rule was met for the first time
  half_width_of_mean, runs_needed:RULE
              half of the interval of the mean; how many runs the rule will want, if the spread stays as it is
Rules: paper (mean and variance change by less than 1e-3 by one more run: nearly a matter of n alone, see lib/stats/stopping.hpp);
       mean=W (the 95 % interval of the mean is at most W m to either side).)";

/// The table of results: one statistic a line.
class Statistics {
 public:
  void add(const std::string& quantity, const std::string& statistic, double value, Interval interval, std::size_t n) {
    table_.add_row({quantity, statistic, format_real(value), format_limit(interval.low), format_limit(interval.high), std::to_string(n)});
  }
  const Table& table() const { return table_; }

 private:
  Table table_{{"quantity", "statistic", "value", "ci_low", "ci_high", "n"}};
};

void add_runs(Statistics& statistics, std::span<const Row> rows, const Ensemble& ensemble) {
  const std::size_t total = ensemble.failure.size();
  statistics.add("runs", "total", static_cast<double>(total), no_interval, total);
  for (const Status status : {Status::slid, Status::stable, Status::left_domain, Status::diverged})
    statistics.add("runs", to_string(status), static_cast<double>(count_of(rows, status)), no_interval, total);
  const Estimate failure = failure_probability(ensemble);
  statistics.add("runs", "probability_of_failure", failure.value, failure.interval, total);
}

void add_moments(Statistics& statistics, const Reach& reach) {
  const Moments moments = moments_of(known_values(reach.sample));
  const std::size_t n = moments.count();
  const Estimate mean = mean_estimate(reach.sample);
  const Estimate variance = variance_estimate(reach.sample);
  statistics.add(reach.quantity, "mean", mean.value, mean.interval, n);
  statistics.add(reach.quantity, "variance", variance.value, variance.interval, n);
  statistics.add(reach.quantity, "sd", std::sqrt(variance.value), {std::sqrt(variance.interval.low), std::sqrt(variance.interval.high)}, n);
  statistics.add(reach.quantity, "min", moments.minimum(), no_interval, n);
  statistics.add(reach.quantity, "max", moments.maximum(), no_interval, n);
}

void add_quantiles(Statistics& statistics, const Reach& reach) {
  for (const double p : quantiles) {
    const Estimate estimate = quantile_estimate(reach.sample, p);
    statistics.add(reach.quantity, "quantile_" + format_real(p), estimate.value, estimate.interval, reach.sample.size());
  }
}

void add_deterministic(Statistics& statistics, const Reach& reach) {
  if (!reach.deterministic) return;
  const Estimate estimate = exceedance_estimate(reach.sample, *reach.deterministic);
  statistics.add(reach.quantity, "deterministic", *reach.deterministic, no_interval, 1);
  statistics.add(reach.quantity, "exceeds_deterministic", estimate.value, estimate.interval, reach.sample.size());
}

void add_fit(Statistics& statistics, const Reach& reach, Family family) {
  const std::span<const double> values = reach.of_slides;
  const std::string name = name_of(family) + "_";
  const std::optional<Fit> fit = fit_of(family, values);
  const auto intervals = fit ? parameter_intervals(family, values) : std::array{no_interval, no_interval};
  for (std::size_t i = 0; i < intervals.size(); ++i)
    statistics.add(reach.quantity, name + parameter_names(family)[i], fit ? fit->parameters[i] : nan, intervals[i], values.size());
  const std::optional<ChiSquare> test = fit ? chi_square(*fit, values) : std::nullopt;
  const auto add = [&](const std::string& what, double value) {
    statistics.add(reach.quantity, name + what, value, no_interval, values.size());
  };
  add("chi_square", test ? test->statistic : nan);
  add("chi_square_bins", test ? static_cast<double>(test->bins) : nan);
  add("chi_square_degrees_of_freedom", test ? static_cast<double>(test->degrees_of_freedom) : nan);
  add("chi_square_p", test ? test->p : nan);
}

void add_slides(Statistics& statistics, const Reach& reach) {
  const Moments moments = moments_of(reach.of_slides);
  const Interval variance = variance_interval(reach.of_slides);
  statistics.add(reach.quantity, "mean_of_slides", moments.mean(), mean_interval(moments), moments.count());
  statistics.add(reach.quantity, "sd_of_slides", moments.standard_deviation(), {std::sqrt(variance.low), std::sqrt(variance.high)},
                 moments.count());
  for (const Family family : {Family::normal, Family::lognormal}) add_fit(statistics, reach, family);
}

void add_paper_verdict(Statistics& statistics, const Reach& reach, const StopRule& rule) {
  const std::vector<double> values = known_values(reach.sample);
  const PaperVerdict verdict = paper_verdict(values);
  const auto add = [&](const std::string& what, double value) { statistics.add(reach.quantity, what, value, no_interval, values.size()); };
  add("stop:" + to_string(rule), verdict.is_met ? 1 : 0);
  add("paper_change_of_mean", verdict.change_of_mean);
  add("paper_change_of_variance", verdict.change_of_variance);
  add("paper_first_met", verdict.first_met ? static_cast<double>(*verdict.first_met) : nan);
}

void add_width_verdict(Statistics& statistics, const Reach& reach, const StopRule& rule) {
  const Estimate mean = mean_estimate(reach.sample);
  const double half_width = (mean.interval.high - mean.interval.low) / 2;
  const std::size_t n = known_values(reach.sample).size();
  const bool is_known = std::isfinite(half_width);
  const double needed = is_known ? std::ceil(static_cast<double>(n) * std::pow(half_width / rule.half_width, 2)) : nan;
  statistics.add(reach.quantity, "stop:" + to_string(rule), half_width <= rule.half_width ? 1 : 0, no_interval, n);
  statistics.add(reach.quantity, "half_width_of_mean", is_known ? half_width : nan, no_interval, n);
  statistics.add(reach.quantity, "runs_needed:" + to_string(rule), needed, no_interval, n);
}

void add_verdicts(Statistics& statistics, const Reach& reach, std::span<const std::string> rules) {
  for (const std::string& text : rules) {
    const StopRule rule = *parse_stop_rule(text);  // checked with the command line
    if (rule.kind == StopRule::Kind::paper) {
      add_paper_verdict(statistics, reach, rule);
    } else {
      add_width_verdict(statistics, reach, rule);
    }
  }
}

void run(const Options& options) {
  const std::vector<Row> rows = read_rows(options.rows);
  const Ensemble ensemble = ensemble_of(rows);
  for (const std::string& caution : cautions(rows)) warn(caution);

  Statistics statistics;
  add_runs(statistics, rows, ensemble);
  for (const Reach* reach : {&ensemble.influence, &ensemble.runout}) {
    add_moments(statistics, *reach);
    add_quantiles(statistics, *reach);
    add_deterministic(statistics, *reach);
    add_slides(statistics, *reach);
    add_verdicts(statistics, *reach, options.stop);
  }
  Provenance origin = provenance("slidezone-statistics 1", "mcstats");
  origin.details.emplace_back("rows", checksum(rows));
  write_output(options.output, to_tsv(statistics.table(), origin));
}

/// The rule as text must be one that parse_stop_rule() takes.
CLI::Validator stop_rule() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        if (parse_stop_rule(text)) return {};
        return "found '" + text + "', expected paper or mean=W with W > 0 in m, e.g. mean=0.2";
      },
      "");
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  Options options;
  CLI::App app{manual, "mcstats"};
  app.add_option("ROWS", options.rows, "Tables of rows, one or several; - is stdin")->capture_default_str();
  app.add_option("--stop", options.stop, "Stopping rule to judge by; may be given several times")
      ->allow_extra_args(false)
      ->check(stop_rule())
      ->type_name("RULE")
      ->capture_default_str();
  app.add_option("-o,--output", options.output, "Where the table goes; - is stdout")->type_name("FILE")->capture_default_str();
  return tool_main(app, "cat rows/*.tsv | mcstats --stop mean=0.2", argc, argv, [&] { run(options); });
}
