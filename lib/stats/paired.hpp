// Two series of the same realizations, as of two scenes whose fields come from the same random numbers: their difference is surer than
// either, as far as they are correlated.
//
// Pairs (a, b) by realization; means m, mean squared deviations m_2.
// - difference of the means: that of the values a - b, with its interval (sample.hpp).
// - ratio of the sds: exp(l / 2), l = ln(s_a^2 / s_b^2) with the standard error of the mean of (a - m_a)^2 / m_2a - (b - m_b)^2 / m_2b,
//   by which l changes with the weight of a pair, and Student's t.
// - correlation: Pearson's.
#pragma once

#include <span>

#include "stats/sample.hpp"

namespace slidezone {

/// The values of one realization in both series, and the block it was drawn in (0: none).
struct Pair {
  double a = 0;
  double b = 0;
  std::uint64_t block = 0;
};

Estimate mean_difference(std::span<const Pair> pairs);

/// nan where either series is constant.
Estimate sd_ratio(std::span<const Pair> pairs);

/// nan where either series is constant.
double correlation(std::span<const Pair> pairs);

}  // namespace slidezone
