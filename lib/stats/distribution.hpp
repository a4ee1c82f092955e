// Distributions fitted to a sample: parameters with intervals, tail, and a test of how well they fit.
//
// - Normal: mean and sd (n - 1) of x.
// - Lognormal: lambda and zeta, mean and sd (n - 1) of ln x (completes Eq. 28); needs every x > 0.
// Intervals of the first parameter by Student, of the second by Bonett (interval.hpp).
// Goodness of fit: Pearson's chi-square on k bins of equal fitted probability, k = floor(2 n^(2/5)) (Mann and Wald 1942, as shortened
// by later practice), at most n / 5 so that 5 values are expected in each, at least 4. Degrees of freedom k - 1 - 2. With parameters
// estimated from the unbinned values the true p lies between those of k - 3 and k - 1 degrees (Chernoff and Lehmann 1954): the p
// given is the smaller. Few bins see little: a p of 0.3 does not make a sample Normal.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "stats/sample.hpp"

namespace slidezone {

enum class Family { normal, lognormal };

struct Fit {
  Family family = Family::normal;
  std::array<double, 2> parameters{};
};

/// Nothing for fewer than 2 values, equal values, and a Lognormal of values <= 0.
std::optional<Fit> fit_of(Family family, std::span<const double> values);

/// Intervals of the parameters, in their order.
std::array<Interval, 2> parameter_intervals(Family family, std::span<const double> values);

/// "normal", "lognormal".
std::string name_of(Family family);

/// What the parameters are called: {"mean", "sd"}, {"lambda", "zeta"}.
std::array<std::string, 2> parameter_names(Family family);

/// P(X <= x) and P(X > x) of the fit.
double cumulative(const Fit& fit, double x);
double tail(const Fit& fit, double x);

struct ChiSquare {
  double statistic = 0;
  std::size_t bins = 0;
  std::size_t degrees_of_freedom = 0;
  double p = 0;
};

/// Nothing where fewer than 20 values leave no degree of freedom.
std::optional<ChiSquare> chi_square(const Fit& fit, std::span<const double> values);

}  // namespace slidezone
