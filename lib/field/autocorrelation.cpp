#include "field/autocorrelation.hpp"

#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_gamma.h>

#include <cmath>
#include <numbers>

namespace slidezone {

/// Through logarithms: neither factor overflows. Below the least lag, where the Bessel function does, the value is 1 to rounding.
static double matern(double nu, double t) {
  const double s = 2 * std::sqrt(std::numbers::pi) * std::exp(gsl_sf_lngamma(nu + 0.5) - gsl_sf_lngamma(nu)) * t;
  constexpr double least = 1e-30, greatest = 700;
  if (s < least) return 1;
  if (s > greatest) return 0;
  return std::exp((1 - nu) * std::numbers::ln2 - gsl_sf_lngamma(nu) + nu * std::log(s) + gsl_sf_bessel_lnKnu(nu, s));
}

double autocorrelation(Autocorrelation function, double smoothness, double t) {
  const double b = 16 * t / 3;
  const double h = 0.75 * t;
  switch (function) {
    case Autocorrelation::single_exponential:
      return std::exp(-2 * t);
    case Autocorrelation::squared_exponential:
      return std::exp(-std::numbers::pi * t * t);
    case Autocorrelation::second_order_markov:
      return (1 + 4 * t) * std::exp(-4 * t);
    case Autocorrelation::third_order_markov:
      return (1 + b + b * b / 3) * std::exp(-b);
    case Autocorrelation::cosine_exponential:
      return std::exp(-t) * std::cos(t);
    case Autocorrelation::binary_noise:
      return t < 1 ? 1 - t : 0;
    case Autocorrelation::matern:
      return matern(smoothness, t);
    case Autocorrelation::spherical:
      return h < 1 ? 1 - 1.5 * h + 0.5 * h * h * h : 0;
  }
  return 0;
}

double autocorrelation(const Correlation& correlation, double dx, double dy) {
  const double cosine = std::cos(correlation.bedding_angle), sine = std::sin(correlation.bedding_angle);
  const double along = std::abs(cosine * dx + sine * dy) / correlation.horizontal_scale;
  const double across = std::abs(cosine * dy - sine * dx) / correlation.vertical_scale;
  const auto rho = [&](double t) { return autocorrelation(correlation.function, correlation.smoothness, t); };
  return correlation.shape == LagShape::separable ? rho(along) * rho(across) : rho(std::hypot(along, across));
}

bool is_separable(const Correlation& correlation) {
  const bool is_product = correlation.shape == LagShape::separable || correlation.function == Autocorrelation::squared_exponential;
  return is_product && correlation.bedding_angle == 0;
}

}  // namespace slidezone
