#include "stats/distribution.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sf_gamma.h>
#include <gsl/gsl_sf_psi.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "stats/gsl_errors.hpp"
#include "stats/moments.hpp"
#include "stats/simplex.hpp"

namespace slidezone {

static constexpr double infinity = std::numeric_limits<double>::infinity();

std::string name_of(Family family) {
  static const std::array<std::string, 5> names = {"normal", "lognormal", "gamma", "weibull", "gev"};
  return names[static_cast<std::size_t>(family)];
}

const std::vector<std::string>& parameter_names(Family family) {
  static const std::array<std::vector<std::string>, 5> names = {
      {{"mean", "sd"}, {"lambda", "zeta"}, {"shape", "scale"}, {"shape", "scale"}, {"location", "scale", "shape"}}};
  return names[static_cast<std::size_t>(family)];
}

// ---- normal and lognormal ----

static std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> logs;
  for (const double value : values) logs.push_back(std::log(value));
  return logs;
}

static Fit fit_by_moments(Family family, std::span<const double> values) {
  const Moments moments = moments_of(values);
  return {family, {moments.mean(), moments.standard_deviation()}};
}

std::optional<std::array<Interval, 2>> parameter_intervals(Family family, const Sample& sample) {
  if (family != Family::normal && family != Family::lognormal) return std::nullopt;
  Sample fitted = sample;
  if (family == Family::lognormal) {
    for (Observation& seen : fitted) seen.value = std::log(seen.value);
  }
  return std::array{mean_estimate(fitted).interval, root(variance_estimate(fitted)).interval};
}

// ---- gamma and weibull ----

/// Newton's method for f(k) = 0 on k > 0; a step to k <= 0 is cut to half the way there. `f` gives the value and its derivative.
template <typename Function>
static double newton_root(double k, Function f) {
  for (int i = 0; i < 100; ++i) {
    const auto [value, slope] = f(k);
    const double next = std::max(k - value / slope, k / 2);
    if (std::abs(next - k) <= 1e-14 * k) return next;
    k = next;
  }
  return k;
}

static Fit fit_gamma(std::span<const double> values) {
  const double mean = moments_of(values).mean();
  const double s = std::log(mean) - moments_of(logarithms(values)).mean();
  const double start = (3 - s + std::sqrt((s - 3) * (s - 3) + 24 * s)) / (12 * s);  // within 1.5 % (Minka 2002)
  const double shape = newton_root(start, [&](double k) { return std::pair{std::log(k) - gsl_sf_psi(k) - s, 1 / k - gsl_sf_psi_1(k)}; });
  return {Family::gamma, {shape, mean / shape}};
}

static Fit fit_weibull(std::span<const double> values) {
  const Moments logs = moments_of(logarithms(values));
  const double top = logs.mean();  // powers are taken of x / exp(top): no overflow
  double mean_power = 0;
  const auto likelihood_slope = [&](double k) {
    double sum = 0, sum_log = 0, sum_log2 = 0;
    for (const double value : values) {
      const double log_ratio = std::log(value) - top;
      const double power = std::exp(k * log_ratio);
      sum += power;
      sum_log += power * log_ratio;
      sum_log2 += power * log_ratio * log_ratio;
    }
    mean_power = sum / static_cast<double>(values.size());
    const double ratio = sum_log / sum;
    return std::pair{ratio - 1 / k, sum_log2 / sum - ratio * ratio + 1 / (k * k)};
  };
  const double start = std::numbers::pi / std::sqrt(6.0) / logs.standard_deviation();  // ln x of a Weibull has sd pi / (sqrt 6 k)
  const double shape = newton_root(start, likelihood_slope);
  likelihood_slope(shape);
  return {Family::weibull, {shape, std::exp(top) * std::pow(mean_power, 1 / shape)}};
}

// ---- generalized extreme values ----

/// ln(1 + shape z) / shape, the Gumbel variate of z = (x - location) / scale; nan outside the support.
static double gumbel_variate(double z, double shape) {
  if (std::abs(shape * z) < 1e-8) return z * (1 - shape * z / 2);
  const double inside = shape * z;
  return inside > -1 ? std::log1p(inside) / shape : std::numeric_limits<double>::quiet_NaN();
}

static double gev_log_density(const std::vector<double>& parameters, double x) {
  const double y = gumbel_variate((x - parameters[0]) / parameters[1], parameters[2]);
  return std::isnan(y) ? -infinity : -std::log(parameters[1]) - (1 + parameters[2]) * y - std::exp(-y);
}

/// Minus the mean log density; infinite where a value lies outside the support.
static double gev_cost(const std::vector<double>& parameters, std::span<const double> values) {
  double sum = 0;
  for (const double x : values) {
    const double y = gumbel_variate((x - parameters[0]) / parameters[1], parameters[2]);
    if (std::isnan(y)) return infinity;
    sum += (1 + parameters[2]) * y + std::exp(-y);
  }
  return std::log(parameters[1]) + sum / static_cast<double>(values.size());
}

/// Hosking, Wallis and Wood (1985): parameters from the first three probability-weighted moments.
static std::vector<double> gev_by_weighted_moments(std::span<const double> values) {
  std::vector<double> x(values.begin(), values.end());
  std::sort(x.begin(), x.end());
  const double n = static_cast<double>(x.size());
  double b0 = 0, b1 = 0, b2 = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double j = static_cast<double>(i);
    b0 += x[i] / n;
    b1 += x[i] * j / (n - 1) / n;
    b2 += x[i] * j * (j - 1) / (n - 1) / (n - 2) / n;
  }
  const double c = (2 * b1 - b0) / (3 * b2 - b0) - std::numbers::ln2 / std::log(3.0);
  const double k = std::clamp(7.8590 * c + 2.9554 * c * c, -0.5, 0.9);  // their k is our -shape
  const double kk = std::abs(k) < 1e-6 ? 1e-6 : k;
  const double gamma = gsl_sf_gamma(1 + kk);
  const double scale = (2 * b1 - b0) * kk / (gamma * (1 - std::pow(2, -kk)));
  return {b0 + scale * (gamma - 1) / kk, scale, -kk};
}

static std::optional<Fit> fit_gev(std::span<const double> values) {
  std::vector<double> first = gev_by_weighted_moments(values);
  if (!(first[1] > 0)) return std::nullopt;
  const auto parameters = [&](std::span<const double> place) {  // the search runs in units of the first guess
    return std::vector{first[0] + first[1] * place[0], first[1] * std::exp(place[1]), place[2]};
  };
  const auto cost = [&](std::span<const double> place) {  // below shape -1 the likelihood has no bound
    if (place[2] <= -1) return infinity;
    return gev_cost(parameters(place), values);
  };
  std::vector<double> start = {0, 0, first[2]};
  while (std::isinf(cost(start)) && start[2] < 1) start[2] += 0.1;  // until every value lies in the support
  const Minimum found = minimum_by_simplex(cost, start, 0.1);
  if (!(found.value < 1e300) || found.place[2] < -0.99) return std::nullopt;
  return Fit{Family::gev, parameters(found.place)};
}

// ---- all families ----

static bool is_positive_only(Family family) { return family == Family::lognormal || family == Family::gamma || family == Family::weibull; }

std::optional<Fit> fit_of(Family family, std::span<const double> values) {
  keep_gsl_from_aborting();
  if (is_positive_only(family) && std::any_of(values.begin(), values.end(), [](double x) { return x <= 0; })) return std::nullopt;
  if (!(moments_of(values).variance() > 0)) return std::nullopt;
  switch (family) {
    case Family::normal:
      return fit_by_moments(family, values);
    case Family::lognormal:
      return fit_by_moments(family, logarithms(values));
    case Family::gamma:
      return fit_gamma(values);
    case Family::weibull:
      return fit_weibull(values);
    case Family::gev:
      return values.size() < 5 ? std::nullopt : fit_gev(values);
  }
  return std::nullopt;
}

double density(const Fit& fit, double x) {
  const std::vector<double>& p = fit.parameters;
  if (is_positive_only(fit.family) && x <= 0) return 0;
  switch (fit.family) {
    case Family::normal:
      return gsl_ran_gaussian_pdf(x - p[0], p[1]);
    case Family::lognormal:
      return gsl_ran_lognormal_pdf(x, p[0], p[1]);
    case Family::gamma:
      return gsl_ran_gamma_pdf(x, p[0], p[1]);
    case Family::weibull:
      return gsl_ran_weibull_pdf(x, p[1], p[0]);
    case Family::gev:
      return std::exp(gev_log_density(p, x));
  }
  return 0;
}

/// exp(-y) of the GEV, y the Gumbel variate: minus the logarithm of the cumulative.
static double gev_exponent(const std::vector<double>& p, double x) {
  const double y = gumbel_variate((x - p[0]) / p[1], p[2]);
  if (std::isnan(y)) return p[2] > 0 ? infinity : 0;  // below the lower end or above the upper end
  return std::exp(-y);
}

double cumulative(const Fit& fit, double x) {
  const std::vector<double>& p = fit.parameters;
  if (is_positive_only(fit.family) && x <= 0) return 0;
  switch (fit.family) {
    case Family::normal:
      return gsl_cdf_gaussian_P(x - p[0], p[1]);
    case Family::lognormal:
      return gsl_cdf_lognormal_P(x, p[0], p[1]);
    case Family::gamma:
      return gsl_cdf_gamma_P(x, p[0], p[1]);
    case Family::weibull:
      return gsl_cdf_weibull_P(x, p[1], p[0]);
    case Family::gev:
      return std::exp(-gev_exponent(p, x));
  }
  return 0;
}

double tail(const Fit& fit, double x) {
  const std::vector<double>& p = fit.parameters;
  if (is_positive_only(fit.family) && x <= 0) return 1;
  switch (fit.family) {
    case Family::normal:
      return gsl_cdf_gaussian_Q(x - p[0], p[1]);
    case Family::lognormal:
      return gsl_cdf_lognormal_Q(x, p[0], p[1]);
    case Family::gamma:
      return gsl_cdf_gamma_Q(x, p[0], p[1]);
    case Family::weibull:
      return gsl_cdf_weibull_Q(x, p[1], p[0]);
    case Family::gev:
      return -std::expm1(-gev_exponent(p, x));
  }
  return 0;
}

/// The fit with the likelihood's own sd, which divides by n.
static Fit of_maximum_likelihood(Fit fit, std::size_t count) {
  if (fit.family != Family::normal && fit.family != Family::lognormal) return fit;
  const double n = static_cast<double>(count);
  fit.parameters[1] *= std::sqrt((n - 1) / n);
  return fit;
}

double akaike_criterion(const Fit& fit, std::span<const double> values) {
  const Fit best = of_maximum_likelihood(fit, values.size());
  const double log_likelihood =
      std::accumulate(values.begin(), values.end(), 0.0, [&](double sum, double x) { return sum + std::log(density(best, x)); });
  return 2 * static_cast<double>(best.parameters.size()) - 2 * log_likelihood;
}

}  // namespace slidezone
