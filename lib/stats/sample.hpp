// A sample of a reach (influence or runout distance) of which some values are known only in part.
//
// - exact: the run ended as it should; the value is the reach.
// - at_least: the run left the grid; the reach is this value or more (censored).
// - unknown: the run diverged; the reach may be anything.
// What follows for an estimate is said where it is made. Two readings of the sample bracket every order statistic and every
// count of exceedances: the lowest values that the runs allow (unknown = -infinity) and the highest (at_least, unknown = infinity).
//
// Runs that depend on each other bear the number of their block; intervals then count blocks (blocks.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stats/blocks.hpp"
#include "stats/interval.hpp"
#include "stats/moments.hpp"

namespace slidezone {

enum class Knowledge { exact, at_least, unknown };

struct Observation {
  double value = 0;
  Knowledge knowledge = Knowledge::exact;
  std::uint64_t block = 0;  // 0: independent of all others
};

/// In the order in which the realizations are numbered.
using Sample = std::vector<Observation>;

/// How many observations are of this kind.
std::size_t count_of(const Sample& sample, Knowledge knowledge);

/// All values but the unknown, censored ones at their lower bound, in the sample's order.
std::vector<double> known_values(const Sample& sample);

/// Whether some runs depend on each other.
bool has_blocks(const Sample& sample);

/// The known values by block, in the order in which blocks begin.
Blocks known_blocks(const Sample& sample);

/// The two readings, ascending.
std::vector<double> lowest_values(const Sample& sample);
std::vector<double> highest_values(const Sample& sample);

struct Estimate {
  double value = 0;
  Interval interval;
};

/// The quantile of probability p. Value: of the known values. Interval: order statistics of the lowest values below, of the highest
/// above, so that it covers whatever the censored and diverged runs would have given.
Estimate quantile_estimate(const Sample& sample, double p, double confidence = standard_confidence);

/// P(X > x). Value: the share among the runs for which it is known whether they exceed x. Interval: of all runs, with the
/// doubtful ones counted as not exceeding for the lower end and as exceeding for the upper.
Estimate exceedance_estimate(const Sample& sample, double x, Band band = Band::exact, double confidence = standard_confidence);

/// Mean and variance of the known values. Censored values make the mean a lower bound: its interval has then no upper end, and that
/// of the variance none at all. Diverged runs are left out, as if what broke them had nothing to do with their reach.
Estimate mean_estimate(const Sample& sample, double confidence = standard_confidence);
Estimate variance_estimate(const Sample& sample, double confidence = standard_confidence);

/// The variance with an interval that allows for a longer tail than the sample shows: kurtosis plus two of its standard errors. For
/// whoever looks at the interval again and again and stops where it is short (stopping.hpp).
Estimate guarded_variance_estimate(const Sample& sample, double confidence = standard_confidence);

/// The root of an estimate and of the ends of its interval, the lower one at least 0: an sd from a variance.
Estimate root(const Estimate& estimate);

}  // namespace slidezone
