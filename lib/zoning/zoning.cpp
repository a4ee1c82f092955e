#include "zoning/zoning.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "core/round_step.hpp"

namespace slidezone {

const std::string& class_of(const Classes& classes, double probability) {
  static const std::string unknown = "unknown";
  assert(classes.names.size() == classes.thresholds.size() + 1);
  if (std::isnan(probability)) return unknown;
  std::size_t index = 0;
  while (index < classes.thresholds.size() && !(probability > classes.thresholds[index])) ++index;
  return classes.names[index];
}

std::vector<Boundary> boundaries(const Sample& sample, const Classes& classes) {
  std::vector<Boundary> result;
  for (std::size_t i = 0; i < classes.thresholds.size(); ++i) {
    const double p = classes.thresholds[i];
    result.push_back({classes.names[i], p, quantile_estimate(sample, 1 - p)});
  }
  return result;
}

std::vector<Boundary> boundaries_by_tail(const Sample& sample, const Classes& classes, const TailFit& tail) {
  const std::vector<double> values = known_values(sample);
  std::vector<Boundary> result = boundaries(sample, classes);
  for (Boundary& boundary : result) {
    if (boundary.probability < tail.share) boundary.distance = tail_quantile(tail, values, boundary.probability);
  }
  return result;
}

static double fitted_exceedance(const std::optional<Fit>& fit, double failure, double distance) {
  return fit ? failure * tail(*fit, distance) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<CurvePoint> exceedance_curve(const Sample& sample, std::span<const double> of_slides, double failure,
                                         std::span<const double> distances, Band band) {
  const std::optional<Fit> normal = fit_of(Family::normal, of_slides);
  const std::optional<Fit> lognormal = fit_of(Family::lognormal, of_slides);
  std::vector<CurvePoint> curve;
  for (const double distance : distances) {
    curve.push_back({distance, exceedance_estimate(sample, distance, band), fitted_exceedance(normal, failure, distance),
                     fitted_exceedance(lognormal, failure, distance)});
  }
  return curve;
}

std::vector<double> curve_distances(double farthest) {
  const double end = 1.25 * (farthest > 0 ? farthest : 1.0);
  const RoundStep step = round_step(end / 200);
  std::vector<double> distances;
  for (double i = 0; distances.empty() || distances.back() < end; ++i) distances.push_back(step.multiple(i));
  return distances;
}

}  // namespace slidezone
