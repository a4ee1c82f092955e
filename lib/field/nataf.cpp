#include "field/nataf.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/error.hpp"
#include "core/text.hpp"

namespace slidezone {

constexpr std::size_t terms = 60;

Nataf::Nataf(const MarginalTransform& transform) : shares_(terms, 0.0) {
  constexpr double last = 8.5, step = 1. / 256;
  for (double g = -last; g <= last; g += step) {
    const double weighted = transform.value(g) * std::exp(-g * g / 2) * step / std::sqrt(2 * std::numbers::pi);
    double before = 0, hermite = 1;  // He_k / sqrt(k!): (k + 1)^(1/2) He_(k+1) = g He_k - k^(1/2) He_(k-1)
    for (std::size_t k = 1; k <= terms; ++k) {
      const double n = static_cast<double>(k);
      const double next = (g * hermite - std::sqrt(n - 1) * before) / std::sqrt(n);
      before = hermite;
      hermite = next;
      shares_[k - 1] += weighted * hermite;
    }
  }
  coefficients_ = shares_;
  for (double& share : shares_) share *= share;
  const double sum = std::accumulate(shares_.begin(), shares_.end(), 0.0);
  for (double& share : shares_) share /= sum;
  for (double& coefficient : coefficients_) coefficient /= std::sqrt(sum);
}

double Nataf::physical(double r) const {
  double sum = 0;
  for (std::size_t k = terms; k-- > 0;) sum = (sum + shares_[k]) * r;
  return sum;
}

/// Bisection, to the last digit.
double Nataf::gaussian(double rho) const {
  constexpr double rounding = 1e-12;
  if (rho >= 1 - rounding) return 1;
  if (rho < physical(-1) - rounding)
    throw Error(ExitCode::data, "a correlation of " + format_brief(rho) +
                                    " between values of this marginal distribution is infeasible; feasible are " +
                                    format_brief(physical(-1)) + " to 1");
  double low = -1, high = 1;
  while (high - low > 1e-15) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (physical(middle) < rho ? low : high) = middle;
  }
  return std::abs(low) < rounding && rho == 0 ? 0 : (low + high) / 2;
}

double physical_correlation(const Nataf& a, const Nataf& b, double r) {
  double sum = 0;
  for (std::size_t k = terms; k-- > 0;) sum = (sum + a.coefficients()[k] * b.coefficients()[k]) * r;
  return sum;
}

double gaussian_correlation(const Nataf& a, const Nataf& b, double rho) {
  constexpr double rounding = 1e-12;
  const double least = physical_correlation(a, b, -1), largest = physical_correlation(a, b, 1);
  if (rho < least - rounding || rho > largest + rounding)
    throw Error(ExitCode::data, "a correlation of " + format_brief(rho) +
                                    " between values of these two marginal distributions is infeasible; feasible are " +
                                    format_brief(least) + " to " + format_brief(largest));
  if (rho == 0) return 0;
  double low = -1, high = 1;
  for (double middle = 0; middle > low && middle < high; middle = (low + high) / 2)
    (physical_correlation(a, b, middle) < rho ? low : high) = middle;
  return high;
}

}  // namespace slidezone
