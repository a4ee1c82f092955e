// Goodness of fit of a distribution whose parameters were estimated from the same values.
//
// - Pearson's chi-square on k bins of equal fitted probability, k = floor(2 n^(2/5)) (Mann and Wald 1942, as shortened by later
//   practice), at most n / 5 so that 5 values are expected in each. Degrees of freedom k - 1 - parameters. With parameters estimated
//   from the unbinned values the true p lies between those of k - 1 - parameters and k - 1 degrees (Chernoff and Lehmann 1954): the p
//   given is the smaller.
// - Anderson and Darling (1952): A^2 = -n - sum (2 i - 1) (ln F(x_i) + ln(1 - F(x_(n+1-i)))) / n; sees the tails.
// - Lilliefors (1967): D = max |F_n - F|, Kolmogorov's distance with estimated parameters.
// p of A^2 and D: by simulation, as Lilliefors did: the share of samples of the family, fitted anew, that lie as far from their fit.
// The law of A^2 and D then depends on n alone for a location-scale family (normal; lognormal and Weibull in ln x), so one simulation
// serves all data. For gamma and GEV it depends on the shape besides, which is taken as fitted: a parametric bootstrap (Stute, Gonzalez
// Manteiga and Presedo Quindimil 1993). Above `simulated_at_most` values it is simulated at that n, with D scaled by
// sqrt(n) - 0.01 + 0.85 / sqrt(n) (Stephens 1974).
// No test proves a fit. Values on a lattice (an influence distance in whole cells) fail all three once there are many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "stats/distribution.hpp"

namespace slidezone {

struct ChiSquare {
  double statistic = 0;
  std::size_t bins = 0;
  std::size_t degrees_of_freedom = 0;
  double p = 0;
};

/// Nothing where so few values leave no degree of freedom (20 for two parameters, 25 for three).
std::optional<ChiSquare> chi_square(const Fit& fit, std::span<const double> values);

struct Distances {
  double anderson_darling = 0;  // A^2; infinite where the fit excludes a value
  double lilliefors = 0;        // D
};
Distances distances(const Fit& fit, std::span<const double> values);

/// Values in a simulated sample: fewer where a fit is slow.
inline constexpr std::size_t simulated_at_most(Family family) { return family == Family::gamma || family == Family::gev ? 100 : 1000; }

/// Whether one simulation serves every member of the family.
inline constexpr bool has_one_law(Family family) { return family != Family::gamma && family != Family::gev; }

/// Simulated distances from their own fit of samples of a family.
struct NullDistances {
  std::size_t count = 0;                 // values in each simulated sample
  std::vector<double> anderson_darling;  // ascending
  std::vector<double> lilliefors;        // ascending, scaled
};

/// Of samples of the fit's family and shape. Nothing for fewer than 5 values.
std::optional<NullDistances> simulated_distances(const Fit& fit, std::size_t count, std::size_t simulations, std::uint64_t seed);

/// P(a sample of the family lies as far from its fit), (1 + hits) / (1 + simulations).
struct DistanceP {
  double anderson_darling = 0;
  double lilliefors = 0;
};
DistanceP p_values(const Distances& found, std::size_t count, const NullDistances& simulated);

}  // namespace slidezone
