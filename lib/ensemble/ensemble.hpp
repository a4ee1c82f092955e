// The realizations of a study as samples: what each run tells of the influence distance and of the runout distance.
//
//   status       reach                                          failed?
//   slid         exact                                          yes
//   stable       exact: as measured, zero but for settlement    no
//   left_domain  at least the value where it was stopped        yes
//   diverged     unknown                                        unknown
//
// Every random realization is in every sample, so that P(reach > x) is the probability that a slope of this kind both fails and
// reaches x. Realization 0, the deterministic run, is no member of the random sample: it is kept apart.
// A run knows the block it was drawn in (antithetic pair, Latin hypercube), so that intervals count what is independent.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rows/row.hpp"
#include "stats/sample.hpp"

namespace slidezone {

struct ReachOfStudy {
  std::string quantity;                 // "influence_m" or "runout_m", as the tables call it
  Sample sample;                        // all random realizations
  Sample slides;                        // those that slid and stayed inside, for distributions given failure
  std::optional<double> deterministic;  // of realization 0, where it is there and ended as it should
};

struct Ensemble {
  ReachOfStudy influence;
  ReachOfStudy runout;
  Sample failure;  // 1 failed, 0 stable
};

Ensemble ensemble_of(std::span<const Row> rows);

/// How many random realizations have this status.
std::size_t count_of(std::span<const Row> rows, Status status);

/// P(failure).
Estimate failure_probability(const Ensemble& ensemble);

/// The number of blocks of random realizations, and how many the largest has: plain runs are blocks of one.
struct BlockCount {
  std::size_t blocks = 0;
  std::size_t size = 0;
  std::size_t incomplete = 0;  // pairs without their twin, hypercubes smaller than the largest
};
BlockCount block_count(std::span<const Row> rows);

/// What a reader of any result must know of runs that are censored or diverged, of blocks that are incomplete or too few, and of a reach
/// that is the same in all runs (all slopes stable, say); empty where there is nothing of the kind.
std::vector<std::string> cautions(std::span<const Row> rows);

}  // namespace slidezone
