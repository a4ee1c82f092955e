#include "stats/tail.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "stats/simplex.hpp"

namespace slidezone {

static constexpr double infinity = std::numeric_limits<double>::infinity();

/// ln(1 + shape z) / shape; infinite beyond the end of a tail with shape < 0.
static double exponential_variate(double z, double shape) {
  if (std::abs(shape * z) < 1e-8) return z * (1 - shape * z / 2);
  return shape * z > -1 ? std::log1p(shape * z) / shape : infinity;
}

/// ((s / p)^shape - 1) / shape, the quantile in units of the scale.
static double scaled_quantile(double ratio, double shape) {
  const double log_ratio = std::log(ratio);
  return std::abs(shape * log_ratio) < 1e-8 ? log_ratio * (1 + shape * log_ratio / 2) : std::expm1(shape * log_ratio) / shape;
}

/// Minus the log-likelihood of exceedances (values less the threshold); infinite where one lies beyond the tail's end, and below shape -1
/// where the likelihood has no bound.
static double cost(std::span<const double> exceedances, double scale, double shape) {
  if (!(scale > 0) || shape <= -1) return infinity;
  double sum = static_cast<double>(exceedances.size()) * std::log(scale);
  for (const double y : exceedances) sum += (1 + shape) * exponential_variate(y / scale, shape);
  return sum;
}

static std::vector<double> exceedances_over(std::span<const double> values, double threshold) {
  std::vector<double> exceedances;
  for (const double value : values) {
    if (value > threshold) exceedances.push_back(value - threshold);
  }
  std::sort(exceedances.begin(), exceedances.end());
  return exceedances;
}

static double kolmogorov_distance(const TailFit& fit, std::span<const double> exceedances) {
  const double n = static_cast<double>(exceedances.size());
  double distance = 0;
  for (std::size_t i = 0; i < exceedances.size(); ++i) {
    const double below = -std::expm1(-exponential_variate(exceedances[i] / fit.scale, fit.shape));
    distance = std::max({distance, static_cast<double>(i + 1) / n - below, below - static_cast<double>(i) / n});
  }
  return distance;
}

std::optional<TailFit> tail_fit(std::span<const double> values) {
  const std::size_t wanted = std::max(least_exceedances, values.size() / 10);
  if (wanted > values.size() / 2) return std::nullopt;
  std::vector<double> descending(values.begin(), values.end());
  std::sort(descending.begin(), descending.end(), std::greater<>());
  TailFit fit;
  fit.threshold = descending[wanted];
  const std::vector<double> exceedances = exceedances_over(values, fit.threshold);
  const Moments moments = moments_of(exceedances);
  if (exceedances.size() < least_exceedances / 2 || !(moments.variance() > 0)) return std::nullopt;  // ties may leave fewer
  fit.exceedances = exceedances.size();
  fit.share = static_cast<double>(exceedances.size()) / static_cast<double>(values.size());
  const double unit = moments.mean();  // the exponential fit, from which the search starts
  const Minimum found = minimum_by_simplex(
      [&](std::span<const double> place) { return cost(exceedances, unit * std::exp(place[0]), place[1]); }, std::vector{0.0, 0.0}, 0.1);
  fit.scale = unit * std::exp(found.place[0]);
  fit.shape = found.place[1];
  if (!(found.value < 1e300) || fit.shape < -0.99) return std::nullopt;
  fit.distance = kolmogorov_distance(fit, exceedances);
  return fit;
}

/// The least cost of all fits whose quantile is `distance` above the threshold: the shape is searched by golden section.
static double profile_cost(std::span<const double> exceedances, double ratio, double distance) {
  const auto at = [&](double shape) { return cost(exceedances, distance / scaled_quantile(ratio, shape), shape); };
  double best_shape = 0;
  double best = infinity;
  for (double shape = -0.98; shape < 3; shape += 0.04) {
    if (const double value = at(shape); value < best) {
      best = value;
      best_shape = shape;
    }
  }
  double low = std::max(best_shape - 0.04, -0.99), high = best_shape + 0.04;
  constexpr double golden = 0.6180339887498949;
  while (high - low > 1e-9) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (at(left) < at(right) ? high : low) = at(left) < at(right) ? right : left;
  }
  return std::min(best, at((low + high) / 2));
}

/// Where the profile has lost `allowed` between a distance that it allows and one that it does not.
static double crossing(const std::function<double(double)>& profile, double allowed, double inside, double outside) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (inside + outside) / 2;
    (profile(middle) <= allowed ? inside : outside) = middle;
  }
  return inside;
}

Estimate tail_quantile(const TailFit& fit, std::span<const double> values, double p) {
  const std::vector<double> exceedances = exceedances_over(values, fit.threshold);
  const double ratio = fit.share / p;
  const double found = fit.scale * scaled_quantile(ratio, fit.shape);
  const auto profile = [&](double distance) { return profile_cost(exceedances, ratio, distance); };
  constexpr double half_chi_square = 1.920729410347062;  // chi^2_1(95 %) / 2
  const double allowed = cost(exceedances, fit.scale, fit.shape) + half_chi_square;
  Estimate estimate{fit.threshold + found, {}};
  estimate.interval.low = fit.threshold + crossing(profile, allowed, found, 0);
  double outside = 2 * found;
  while (outside < 1000 * found && profile(outside) <= allowed) outside *= 2;
  if (outside < 1000 * found) estimate.interval.high = fit.threshold + crossing(profile, allowed, found, outside);
  return estimate;
}

}  // namespace slidezone
