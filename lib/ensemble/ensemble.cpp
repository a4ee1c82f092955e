#include "ensemble/ensemble.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace slidezone {

static bool is_random(const Row& row) { return row.realization > 0; }

static Knowledge knowledge_of(Status status) {
  if (status == Status::left_domain) return Knowledge::at_least;
  return status == Status::diverged ? Knowledge::unknown : Knowledge::exact;
}

static Reach reach_of(std::span<const Row> rows, const std::string& quantity, double Row::*value) {
  Reach reach{quantity, {}, {}, std::nullopt};
  for (const Row& row : rows) {
    const Knowledge knowledge = knowledge_of(row.status);
    if (is_random(row)) {
      reach.sample.push_back({row.*value, knowledge});
      if (row.status == Status::slid) reach.of_slides.push_back(row.*value);
    } else if (knowledge == Knowledge::exact) {
      reach.deterministic = row.*value;
    }
  }
  return reach;
}

static Sample failures(std::span<const Row> rows) {
  Sample sample;
  for (const Row& row : rows) {
    if (!is_random(row)) continue;
    const bool is_known = row.status != Status::diverged;
    sample.push_back({row.status == Status::stable ? 0.0 : 1.0, is_known ? Knowledge::exact : Knowledge::unknown});
  }
  return sample;
}

Ensemble ensemble_of(std::span<const Row> rows) {
  if (std::none_of(rows.begin(), rows.end(), is_random))
    throw Error(ExitCode::data, "found only realization 0, the deterministic run; statistics want random realizations 1, 2, ...");
  return {reach_of(rows, "influence_m", &Row::influence), reach_of(rows, "runout_m", &Row::runout), failures(rows)};
}

std::size_t count_of(std::span<const Row> rows, Status status) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return is_random(row) && row.status == status; }));
}

Estimate failure_probability(const Ensemble& ensemble) { return exceedance_estimate(ensemble.failure, 0.5); }

std::vector<std::string> cautions(std::span<const Row> rows) {
  std::vector<std::string> texts;
  const std::size_t censored = count_of(rows, Status::left_domain);
  const std::size_t diverged = count_of(rows, Status::diverged);
  if (censored > 0)
    texts.push_back(std::to_string(censored) +
                    " of the runs left the grid: their reach is a lower bound, and so are means and quantiles; "
                    "make the grid longer");
  if (diverged > 0)
    texts.push_back(std::to_string(diverged) +
                    " of the runs diverged: means leave them out, bands of probabilities and quantiles allow "
                    "for any reach of theirs");
  return texts;
}

}  // namespace slidezone
