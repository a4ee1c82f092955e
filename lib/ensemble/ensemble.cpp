#include "ensemble/ensemble.hpp"

#include <algorithm>
#include <map>

#include "core/text.hpp"

namespace slidezone {

static bool is_random(const Row& row) { return row.realization > 0; }

static Knowledge knowledge_of(Status status) {
  if (status == Status::left_domain) return Knowledge::at_least;
  return status == Status::diverged ? Knowledge::unknown : Knowledge::exact;
}

/// As a sample counts it: 0 stands for no block.
static std::uint64_t block_of(const Row& row) { return row.design == Design::plain ? 0 : row.block + 1; }

static ReachOfStudy reach_of(std::span<const Row> rows, const std::string& quantity, double Row::*value) {
  ReachOfStudy reach{quantity, {}, {}, std::nullopt};
  for (const Row& row : rows) {
    const Knowledge knowledge = knowledge_of(row.status);
    if (is_random(row)) {
      reach.sample.push_back({row.*value, knowledge, block_of(row)});
      if (row.status == Status::slid) reach.slides.push_back(reach.sample.back());
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
    sample.push_back({row.status == Status::stable ? 0.0 : 1.0, is_known ? Knowledge::exact : Knowledge::unknown, block_of(row)});
  }
  return sample;
}

Ensemble ensemble_of(std::span<const Row> rows) {
  return {reach_of(rows, "influence_m", &Row::influence), reach_of(rows, "runout_m", &Row::runout), failures(rows)};
}

std::size_t count_of(std::span<const Row> rows, Status status) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return is_random(row) && row.status == status; }));
}

Estimate failure_probability(const Ensemble& ensemble) { return exceedance_estimate(ensemble.failure, 0.5); }

BlockCount block_count(std::span<const Row> rows) {
  std::map<std::uint64_t, std::size_t> sizes;
  BlockCount count;
  for (const Row& row : rows) {
    if (!is_random(row)) continue;
    const std::size_t size = ++sizes[row.design == Design::plain ? row.realization : row.block];
    count.size = std::max({count.size, size, row.design == Design::antithetic ? std::size_t{2} : 1});
  }
  count.blocks = sizes.size();
  count.incomplete =
      static_cast<std::size_t>(std::count_if(sizes.begin(), sizes.end(), [&](const auto& block) { return block.second < count.size; }));
  return count;
}

static std::vector<std::string> cautions_on_blocks(std::span<const Row> rows) {
  const BlockCount count = block_count(rows);
  if (count.size <= 1) return {};
  const std::string blocks = std::to_string(count.blocks) + (count.size == 2 ? " pair" : " block") + (count.blocks == 1 ? "" : "s");
  std::vector<std::string> texts;
  if (count.incomplete > 0)
    texts.push_back(blocks + ", incomplete: " + std::to_string(count.incomplete) + "; their runs count, and intervals allow for it");
  if (count.blocks < 10)
    texts.push_back("only " + blocks + ": intervals rest on what differs between them, and are wide; below 5 some have no end");
  return texts;
}

static std::vector<std::string> cautions_on_spread(const Ensemble& ensemble) {
  std::vector<std::string> texts;
  for (const ReachOfStudy* reach : {&ensemble.influence, &ensemble.runout}) {
    const Moments moments = moments_of(known_values(reach->sample));
    if (moments.count() >= 2 && moments.minimum() == moments.maximum())
      texts.push_back(reach->quantity + " is " + format_brief(moments.mean()) + " in all " + std::to_string(moments.count()) +
                      " runs: they tell nothing of its spread, and its mean has no interval");
  }
  return texts;
}

std::vector<std::string> cautions(std::span<const Row> rows) {
  std::vector<std::string> texts = cautions_on_blocks(rows);
  const std::size_t censored = count_of(rows, Status::left_domain);
  const std::size_t diverged = count_of(rows, Status::diverged);
  if (censored > 0)
    texts.push_back(std::to_string(censored) +
                    " of the runs left the grid, or failed back to the left wall: their reach is a lower bound, and so are means and "
                    "quantiles; make the grid longer, or the ground behind the crest");
  if (diverged > 0)
    texts.push_back(std::to_string(diverged) +
                    " of the runs diverged: means leave them out, bands of probabilities and quantiles allow "
                    "for any reach of theirs");
  for (std::string& text : cautions_on_spread(ensemble_of(rows))) texts.push_back(std::move(text));
  return texts;
}

}  // namespace slidezone
