// The lognormal marginal distribution, and the limits of values.
//
// Eq. 28, completed: value = exp(lambda + zeta g) of a standard normal g has the wanted mean and coefficient of variation
// (COV) with zeta^2 = log(1 + COV^2), lambda = log(mean) - zeta^2 / 2. The paper's equation leaves out both definitions.
#pragma once

#include <cstddef>
#include <span>

namespace slidezone {

struct Lognormal {
  double lambda = 0;  // mean of the logarithm
  double zeta = 0;    // standard deviation of the logarithm
};

/// mean > 0, cov > 0.
Lognormal lognormal(double mean, double cov);

/// Standard normals become lognormal values, in place.
void make_lognormal(std::span<double> values, Lognormal marginal);

/// Raises values below `floor` to it, in place; returns how many there were.
std::size_t raise_to_floor(std::span<double> values, double floor);

/// The same from above.
std::size_t lower_to_ceiling(std::span<double> values, double ceiling);

}  // namespace slidezone
