#include "stats/distribution.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stats/gsl_errors.hpp"

namespace slidezone {

static std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> logs;
  for (const double value : values) logs.push_back(std::log(value));
  return logs;
}

/// The values whose mean and sd are the parameters.
static std::vector<double> transformed(Family family, std::span<const double> values) {
  return family == Family::lognormal ? logarithms(values) : std::vector<double>(values.begin(), values.end());
}

std::optional<Fit> fit_of(Family family, std::span<const double> values) {
  if (family == Family::lognormal && std::any_of(values.begin(), values.end(), [](double x) { return x <= 0; })) return std::nullopt;
  const Moments moments = moments_of(transformed(family, values));
  if (!(moments.variance() > 0)) return std::nullopt;
  return Fit{family, {moments.mean(), moments.standard_deviation()}};
}

std::array<Interval, 2> parameter_intervals(Family family, std::span<const double> values) {
  const std::vector<double> fitted = transformed(family, values);
  const Interval variance = variance_interval(fitted);
  return {mean_interval(moments_of(fitted)), Interval{std::sqrt(variance.low), std::sqrt(variance.high)}};
}

std::string name_of(Family family) { return family == Family::normal ? "normal" : "lognormal"; }

std::array<std::string, 2> parameter_names(Family family) {
  if (family == Family::normal) return {"mean", "sd"};
  return {"lambda", "zeta"};
}

/// The standard Normal variate of x; -infinity below the support of a Lognormal.
static double standardized(const Fit& fit, double x) {
  const double fitted = fit.family == Family::lognormal ? (x > 0 ? std::log(x) : -std::numeric_limits<double>::infinity()) : x;
  return (fitted - fit.parameters[0]) / fit.parameters[1];
}

double cumulative(const Fit& fit, double x) { return gsl_cdf_ugaussian_P(standardized(fit, x)); }

double tail(const Fit& fit, double x) { return gsl_cdf_ugaussian_Q(standardized(fit, x)); }

static std::size_t bin_count(std::size_t count) {
  const auto n = static_cast<double>(count);
  return std::min(static_cast<std::size_t>(2 * std::pow(n, 0.4)), count / 5);
}

std::optional<ChiSquare> chi_square(const Fit& fit, std::span<const double> values) {
  const std::size_t bins = bin_count(values.size());
  const std::size_t estimated = fit.parameters.size();
  if (bins < estimated + 2) return std::nullopt;
  std::vector<double> found(bins, 0);
  for (const double value : values) {
    const double place = cumulative(fit, value) * static_cast<double>(bins);
    found[std::min(static_cast<std::size_t>(place), bins - 1)] += 1;
  }
  const double expected = static_cast<double>(values.size()) / static_cast<double>(bins);
  ChiSquare result{0, bins, bins - 1 - estimated, 0};
  for (const double count : found) result.statistic += (count - expected) * (count - expected) / expected;
  keep_gsl_from_aborting();
  result.p = gsl_cdf_chisq_Q(result.statistic, static_cast<double>(result.degrees_of_freedom));
  return result;
}

}  // namespace slidezone
