// Intervals for runs that come in blocks: antithetic pairs, Latin hypercubes. Blocks are independent, the runs within one are not.
//
// B blocks, block b holds n_b values, n in all; a plain run is a block of one. Blocks may be incomplete: everything is a ratio of sums
// over blocks, linearized (Cochran 1977, "Sampling techniques", chapters 6 and 9).
// - mean m: +- t_{B-1} sqrt(B / (B - 1) sum d_b^2) / n, d_b = sum over the block of (x - m). With blocks of one it is Student's.
// - variance s^2: with e_b = (B / n) sum over the block of ((x - m)^2 / m_2 - 1), m_2 the mean of (x - m)^2, and V the mean of e_b^2, the
//   interval is c s^2 exp(+- t_{B-1} c sqrt((V + 3 B / n^2) / (B - 1))), c = n / (n - t): Bonett's (interval.hpp) where blocks are of one,
//   for V is then the kurtosis less 1. With `errors` > 0 V is raised by so many of its own standard errors: few runs show too little of a
//   long tail.
// - proportion: by the number of independent runs that would tell as much, n / D (t_{n-1} / t_{B-1})^2 (Korn and Graubard 1998, "Confidence
//   intervals for proportions with small expected number of positive counts", Surv. Methodol. 24, 193-201), at most n. D is the design
//   effect: the variance of the share between blocks over that of independent runs. Where all runs agree the sample shows none, and it is
//   taken as L / (L - 1), L the size of a block: no pair or Latin hypercube has a greater one (Owen 1997, "Monte Carlo variance of
//   scrambled net quadrature", SIAM J. Numer. Anal. 34, section 4).
// So a design shortens the intervals of mean and variance as far as it helps; of probabilities and quantiles they are conservative, those
// of as many independent runs at best. Slow tests simulate both.
#pragma once

#include <vector>

#include "stats/interval.hpp"

namespace slidezone {

using Blocks = std::vector<std::vector<double>>;

/// Of all values.
Moments moments_of_all(const Blocks& blocks);

/// Standard errors of mean and variance; nan for fewer than 2 blocks.
double mean_error(const Blocks& blocks);
double variance_error(const Blocks& blocks);

/// Infinite on both ends for fewer than 2 blocks and for equal values.
Interval mean_interval(const Blocks& blocks, double confidence = standard_confidence);

/// [0, infinity) for fewer than 5 blocks and for equal values.
Interval variance_interval(const Blocks& blocks, double errors, double confidence = standard_confidence);

/// The number of independent runs that would tell as much of the share of values that are 1, the others being 0; 0 for a single block of
/// more than one run.
double effective_count(const Blocks& blocks, double confidence = standard_confidence);

}  // namespace slidezone
