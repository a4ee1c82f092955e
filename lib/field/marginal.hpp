// Marginal distributions: a standard normal g becomes value = F^-1(Phi(g)), the isoprobabilistic transform.
//
//   lognormal         exp(lambda + zeta g), field/lognormal.hpp
//   normal            mean (1 + cov g); may be negative
//   truncated normal  that distribution, cut at low and high: its mean and cov are those before the cut
//   beta              on [low, high], alpha = m nu, beta = (1 - m) nu, m = (mean - low)/(high - low), nu = m (1 - m)/s^2 - 1,
//                     s = mean cov/(high - low)
//   gamma             shape 1/cov^2, scale mean cov^2
//   Weibull           shape k with Gamma(1 + 2/k)/Gamma(1 + 1/k)^2 = 1 + cov^2, scale mean/Gamma(1 + 1/k)
//   uniform           mean (1 -+ sqrt(3) cov)
//   empirical         the sorted data, item i of n at probability (i - 1/2)/n (Hazen), linear between, constant beyond
//
// Quantiles of GSL; those of truncated normal, beta, gamma and Weibull by a table at every 1/64 of g and cubics: to 1e-7 of the standard
// deviation for |g| < 6 and COV up to 1 (tests/unit/marginal.cpp). COVs at which the table would miss it by 0.1 % are refused.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "field/model.hpp"

namespace slidezone {

class MarginalTransform {
 public:
  /// Throws ExitCode::data for parameters that no distribution has (a beta of too large a spread) or whose quantiles are out of reach.
  explicit MarginalTransform(const Marginal& marginal);

  /// The value of one standard normal, exactly.
  double value(double g) const { return quantile_(g); }

  /// The standard normal of a value; of one at which data are level, the middle of its probabilities; nothing beyond those of +-8.6.
  std::optional<double> normal(double value) const;

  /// Change of the value with the normal.
  double slope(double g) const;

  /// Standard normals become values, in place.
  void apply(std::span<double> values) const;

 private:
  Marginal marginal_;
  std::function<double(double)> quantile_;  // of a standard normal
  std::vector<double> table_;               // empty where the transform needs none
};

}  // namespace slidezone
