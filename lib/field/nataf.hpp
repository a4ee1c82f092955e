// The correlation of a Gaussian field whose values, transformed to their marginal distribution, have a wanted correlation (Nataf 1962).
//
// With the transform's Hermite coefficients c_k = E[h(Z) He_k(Z)] / sqrt(k!), values of a Gaussian correlation r have
//   rho(r) = sum c_k^2 r^k / sum c_k^2,  k = 1, 2, ...
// which rises from rho(-1) to rho(1) = 1: correlations below rho(-1) are infeasible. For a lognormal it is
// log(1 + rho cov^2) / zeta^2 = r. The coefficients come from the trapezoidal rule, exact to rounding for smooth transforms; terms up
// to k = 60. Values of two transforms, coefficients a_k and b_k, have rho(r) = sum a_k b_k r^k / sqrt(sum a_k^2 sum b_k^2).
#pragma once

#include <vector>

#include "field/marginal.hpp"

namespace slidezone {

class Nataf {
 public:
  explicit Nataf(const MarginalTransform& transform);

  /// Correlation of the values at Gaussian correlation r in [-1, 1].
  double physical(double r) const;

  /// The inverse. Throws ExitCode::data, with the feasible range, for an infeasible correlation.
  double gaussian(double rho) const;

  /// c_k / sqrt(sum), from k = 1.
  const std::vector<double>& coefficients() const { return coefficients_; }

 private:
  std::vector<double> shares_;  // c_k^2 / sum, from k = 1
  std::vector<double> coefficients_;
};

/// Correlation of the values of two transforms at Gaussian correlation r in [-1, 1].
double physical_correlation(const Nataf& a, const Nataf& b, double r);

/// The inverse. Throws as above.
double gaussian_correlation(const Nataf& a, const Nataf& b, double rho);

}  // namespace slidezone
