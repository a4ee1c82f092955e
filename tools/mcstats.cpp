// mcstats: what the realizations of a study say of influence and runout distance, and how well.
// Rows ("slidezone-row 1") -> one table: statistics ("slidezone-statistics 1"), a running trace ("slidezone-trace 1"), a histogram
// ("slidezone-histogram 1") or densities of the fits ("slidezone-densities 1").
//   cat rows/*.tsv | mcstats --stop mean=0.2
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/provenance.hpp"
#include "core/tool.hpp"
#include "ensemble/ensemble.hpp"
#include "io/file.hpp"
#include "io/table.hpp"
#include "rows/row.hpp"
#include "summary/summary.hpp"

namespace slidezone {
namespace {

struct Options {
  std::vector<std::string> rows = {"-"};
  std::string other_rows;  // of the study to compare with
  bool wants_trace = false;
  bool wants_histogram = false;
  bool wants_densities = false;
  std::vector<std::string> stop = {"paper", "mean=0.2"};
  std::uint64_t least_runs = 100;
  Resampling resampling;
  std::string output = "-";
};

const char* const manual =
    R"(Moments, quantiles, distribution fits and convergence of the reach of a study's landslides.

Of the influence distance behind the crest (influence_m) and the runout distance before the toe (runout_m).

Rows of at least two random realizations; slides that all run equally far are refused, for no two random fields do that.
Columns of the result: quantity, statistic, value, ci_low and ci_high (95 % interval), n (number of values that went in). A value or
interval that does not exist is nan; an end that the sample cannot give is "unbounded". Distances in m, variances in m2.
  runs        total; blocks: of how many independent runs, pairs or hypercubes; count by status: slid, stable, left_domain, diverged;
              probability_of_failure; next_look (below)
  mean variance sd skewness kurtosis min max quantile_P
              of all runs, failed or not. A stable run counts with the reach that it has. A run that left the grid counts with the
              reach it had: means and quantiles are then lower bounds and lose their upper end. Diverged runs are left out of moments;
              intervals of quantiles and probabilities allow for any reach of theirs. Kurtosis is 3 for a Normal. Intervals: mean by
              Student, variance and sd by Bonett (with the kurtosis), quantiles by order statistics, skewness and kurtosis by bootstrap.
              Of a reach that is the same in all runs, such as the influence distance of slopes that all stand, the mean has no interval
              and the spread is nan; probability_of_failure has its interval as always
  standard_error_of_mean standard_error_of_variance standard_error_of_sd
              the latter two with the kurtosis
  bootstrap_mean bootstrap_variance bootstrap_sd
              the same values with BCa bootstrap intervals
  deterministic, exceeds_deterministic, reaches_deterministic
              the reach of realization 0, P(reach > that) and P(reach >= that), where the rows hold it; the two differ for the influence
              distance, which moves in whole columns of cells. Realization 0 enters nothing else
  mean_of_slides sd_of_slides, FAMILY_*
              given failure: of the runs that slid and stayed in the grid. FAMILY is normal, lognormal, gamma, weibull or gev:
              parameters; chi_square with its bins, degrees of freedom and p; anderson_darling and lilliefors with p (simulated);
              aic, the smaller the better. A large p from few runs says little
  stop:RULE   1 where the rule is met, else 0
  half_width:RULE, runs_needed:RULE
              half of the rule's interval, and that interval; how many runs it will want, if the spread stays as it is
  paper_change_of_mean paper_change_of_variance paper_first_met
              by the last run; the number of runs after which the paper's rule was met for the first time
With --against OTHER, instead, of the realizations that both studies know exactly:
  mean_difference sd_ratio correlation
              mean less the other's, sd over the other's, and how alike the two are. By pairs of one number: surer than two studies apart
              where both scenes have the same seed and mesh of fields, for then their fields come from the same random numbers
Rules: mean=W, sd=W, quantile_P=W (half of the 95 % interval is at most W m), exceeds_X=W (likewise of P(reach > X m), W a probability),
       for both quantities or for one ("runout_m:mean=0.1"); not met before --least-runs. The interval of sd=W is for a kurtosis two
       standard errors above the sample's: where a study ended by it, quote that of half_width, not that of sd. paper: mean and
       variance change by less than 1e-3 by one more run, which is nearly a matter of the number of runs alone.
       Look again only at next_look runs: who looks after each run and stops at the first good one gets intervals that cover less
       than 95 %.
Designs: of rows drawn in antithetic pairs or Latin hypercubes (column design) the intervals of mean, sd and bootstrap count pairs or
       hypercubes, and gain what the design gains. Those of probabilities and quantiles are conservative: for fewer independent runs where
       those of a block agree, never for more. p values are of independent runs, else nan. One table holds one design.)";

/// The kind of table that is asked for, as its schema is called.
std::string kind_of(const Options& options) {
  if (options.wants_trace) return "trace";
  if (options.wants_histogram) return "histogram";
  return options.wants_densities ? "densities" : "statistics";
}

SummaryOptions summary_options(const Options& options) {
  SummaryOptions summary{{}, options.least_runs, options.resampling};
  for (const std::string& text : options.stop) summary.rules.push_back(*parse_stop_rule(text));  // checked with the command line
  return summary;
}

/// What the study has more than another one; the warnings are on both.
Table comparison(std::span<const Row> rows, const Options& options, Provenance& origin) {
  const std::vector<Row> others = read_rows(std::span(&options.other_rows, 1));
  for (const std::string& caution : cautions(others)) warn("other study: " + caution);
  origin.details.emplace_back("other rows", checksum(others));
  return comparison_table(rows, others);
}

Table table_of(const std::string& kind, std::span<const Row> rows, const Ensemble& ensemble, const Options& options) {
  if (kind == "trace") return trace_table(ensemble);
  if (kind == "histogram") return histogram_table(ensemble);
  if (kind == "densities") return density_table(ensemble);
  return statistics_table(rows, ensemble, summary_options(options));
}

void run(const Options& options) {
  const std::vector<Row> rows = read_rows(options.rows);
  const Ensemble ensemble = ensemble_of(rows);
  for (const std::string& caution : cautions(rows)) warn(caution);

  const std::string kind = kind_of(options);
  Provenance origin = provenance("slidezone-" + kind + " 1", "mcstats");
  origin.details.emplace_back("rows", checksum(rows));
  if (!options.other_rows.empty()) {
    const Table table = comparison(rows, options, origin);
    return write_output(options.output, to_tsv(table, origin));
  }
  if (kind == "statistics") {
    origin.details.emplace_back("seed", std::to_string(options.resampling.seed));
    origin.details.emplace_back("resamples", std::to_string(options.resampling.resamples));
  }
  write_output(options.output, to_tsv(table_of(kind, rows, ensemble, options), origin));
}

CLI::Validator stop_rule() {
  return text_that([](const std::string& text) { return parse_stop_rule(text).has_value(); },
                   "paper, mean=W, sd=W, quantile_P=W or exceeds_X=W, e.g. mean=0.2 or runout_m:quantile_0.9=0.5");
}

void add_kinds(CLI::App& app, Options& options) {
  auto* trace = app.add_flag("--trace", options.wants_trace, "Instead: running mean and sd with intervals, run by run");
  auto* histogram = app.add_flag("--histogram", options.wants_histogram, "Instead: histogram of the runs that slid");
  auto* densities = app.add_flag("--densities", options.wants_densities, "Instead: density and cumulative of the fits, and the sample's");
  auto* against =
      app.add_option("--against", options.other_rows, "Instead: what this study has more than that of OTHER, its rows")->type_name("OTHER");
  trace->excludes(histogram)->excludes(densities)->excludes(against);
  histogram->excludes(densities)->excludes(against);
  densities->excludes(against);
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  Options options;
  CLI::App app{manual, "mcstats"};
  app.add_option("ROWS", options.rows, "Tables of rows, one or several; - is stdin")->capture_default_str();
  add_kinds(app, options);
  app.add_option("--stop", options.stop, "Stopping rule to judge by; may be given several times")
      ->allow_extra_args(false)
      ->check(stop_rule())
      ->type_name("RULE")
      ->capture_default_str();
  app.add_option("--least-runs", options.least_runs, "Runs before a rule of width can be met")
      ->check(whole_number(2))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--resamples", options.resampling.resamples,
                 "Bootstrap resamples; half as many samples give a simulated p, of gamma and gev an eighth")
      ->check(whole_number(200, 1'000'000))
      ->type_name("B")
      ->capture_default_str();
  app.add_option("--seed", options.resampling.seed, "Seed of the resamples")->check(whole_number(0))->type_name("S")->capture_default_str();
  app.add_option("-o,--output", options.output, "Where the table goes; - is stdout")->type_name("FILE")->capture_default_str();
  return tool_main(app, "cat rows/*.tsv | mcstats --stop mean=0.2", argc, argv, [&] { run(options); });
}
