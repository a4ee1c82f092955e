#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "stats/paired.hpp"
#include "summary/summary.hpp"

namespace slidezone {

/// The reaches of the realizations that both studies know exactly. Rows are ordered by realization.
static std::vector<Pair> pairs_of(std::span<const Row> rows, std::span<const Row> others, double Row::*reach) {
  const auto is_exact = [](const Row& row) { return row.realization > 0 && (row.status == Status::slid || row.status == Status::stable); };
  std::vector<Pair> pairs;
  for (const Row& row : rows) {
    const auto other = std::ranges::lower_bound(others, row.realization, {}, &Row::realization);
    if (other == others.end() || other->realization != row.realization || !is_exact(row) || !is_exact(*other)) continue;
    pairs.push_back({row.*reach, (*other).*reach, row.design == Design::plain ? 0 : row.block + 1});
  }
  return pairs;
}

Table comparison_table(std::span<const Row> rows, std::span<const Row> others) {
  Table table({"quantity", "statistic", "value", "ci_low", "ci_high", "n"});
  for (const auto& [quantity, reach] : {std::pair{"influence_m", &Row::influence}, std::pair{"runout_m", &Row::runout}}) {
    const std::vector<Pair> pairs = pairs_of(rows, others, reach);
    if (pairs.size() < 2) throw Error(ExitCode::data, "--against: fewer than two realizations end as they should in both studies");
    const auto add = [&, name = quantity](const std::string& statistic, double value, const std::string& low, const std::string& high) {
      table.add_row({name, statistic, format_real(value), low, high, std::to_string(pairs.size())});
    };
    const auto add_estimate = [&](const std::string& statistic, const Estimate& estimate) {
      add(statistic, estimate.value, format_limit(estimate.interval.low), format_limit(estimate.interval.high));
    };
    add_estimate("mean_difference", mean_difference(pairs));
    add_estimate("sd_ratio", sd_ratio(pairs));
    add("correlation", correlation(pairs), "nan", "nan");
  }
  return table;
}

}  // namespace slidezone
