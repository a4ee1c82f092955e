// What mcstats prints of a study, as tables: statistics, running traces, histograms, densities.
//
// Every table has the column `quantity`: influence_m, runout_m, or runs for counts of realizations. Columns and statistics are
// explained by `mcstats --help` and data-schemas/; how each number is found, by lib/stats.
#pragma once

#include <span>
#include <vector>

#include "ensemble/ensemble.hpp"
#include "io/table.hpp"
#include "rows/row.hpp"
#include "stats/bootstrap.hpp"
#include "stats/stopping.hpp"

namespace slidezone {

struct SummaryOptions {
  std::vector<StopRule> rules;
  std::size_t least_runs = 100;  // no rule of width is met before
  Resampling resampling;         // of bootstrap intervals, and of simulated p values
};

/// quantity statistic value ci_low ci_high n
Table statistics_table(std::span<const Row> rows, const Ensemble& ensemble, const SummaryOptions& options);

/// What the study of `rows` has more than that of `others`, by the realizations that both know exactly, in the columns of
/// statistics_table(): mean_difference, sd_ratio, correlation. Throws Error(ExitCode::data) for fewer than two of them.
Table comparison_table(std::span<const Row> rows, std::span<const Row> others);

/// After each known value in turn: mean and sd with their 95 % intervals, and how much they changed. The sd's interval comes from the
/// running kurtosis: s exp(+- z / 2 sqrt((b_2 - (n - 3) / (n - 1)) / n)); both count blocks where runs were drawn in blocks.
Table trace_table(const Ensemble& ensemble);

/// Counts and densities of the runs that slid, in bins of Freedman and Diaconis (1981): 2 (q75 - q25) n^(-1/3), rounded to 1, 2 or 5
/// times a power of ten.
Table histogram_table(const Ensemble& ensemble);

/// Cumulative share of the runs that slid, and density and cumulative of every fit, at 401 places over their range and a quarter of it
/// to either side.
Table density_table(const Ensemble& ensemble);

}  // namespace slidezone
