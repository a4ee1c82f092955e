#include "mpm/nonlocal_softening.hpp"

#include <algorithm>
#include <cmath>

namespace slidezone {

/// Gaussian weights of distances 0, 1, ... spacings, up to three standard deviations.
static std::vector<double> gaussian(double deviation, double spacing) {
  const double farthest = 3 * deviation * (1 + 1e-9);  // a place on the cut belongs to it whatever rounding does
  std::vector<double> weights;
  for (int k = 0; k * spacing <= farthest; ++k) weights.push_back(std::exp(-0.5 * std::pow(k * spacing / deviation, 2)));
  return weights;
}

/// The strain at which softening is complete, up to exp(-4).
static double cap_of(const Material& soil) {
  return soil.softening_shape > 0 ? soil.softening_threshold + 4 / soil.softening_shape : soil.softening_threshold;
}

NonlocalAverage::NonlocalAverage(const Points& points, const std::vector<Material>& soils, double spacing_x, double spacing_y,
                                 NonlocalSoftening settings)
    : settings_(settings), place_(points.count()), soil_(points.count()) {
  for (const Material& soil : soils) caps_.push_back(cap_of(soil));
  along_x_.weights = gaussian(settings.length / 2, spacing_x);
  along_y_.weights = gaussian(settings.length / 2, spacing_y);
  const auto column = [&](std::size_t p) { return static_cast<std::size_t>(std::lround(points.x[p] / spacing_x - 0.5)); };
  const auto row = [&](std::size_t p) { return static_cast<std::size_t>(std::lround(points.y[p] / spacing_y - 0.5)); };
  for (std::size_t p = 0; p < points.count(); ++p) {
    columns_ = std::max(columns_, column(p) + 1);
    rows_ = std::max(rows_, row(p) + 1);
  }
  for (std::size_t p = 0; p < points.count(); ++p) {
    const auto label = static_cast<std::size_t>(points.label[p]);
    place_[label] = column(p) * rows_ + row(p);
    soil_[label] = points.soil[p];
  }
  for (std::size_t soil = 0; soil < soils.size(); ++soil) {
    std::vector<double> present(columns_ * rows_, 0.0);
    for (std::size_t label = 0; label < place_.size(); ++label)
      if (soil_[label] == static_cast<int>(soil)) present[place_[label]] = 1;
    occupancy_.push_back(smoothed(present));
  }
}

/// Adds weight times the values at a distance of `shift` places, both ways, within lines of `length` places.
static void add_shifted(std::vector<double>& to, const std::vector<double>& from, std::size_t shift, double weight) {
  const std::size_t count = to.size() - shift;
  for (std::size_t k = 0; k < count; ++k) to[k] += weight * from[k + shift];
  for (std::size_t k = 0; k < count; ++k) to[k + shift] += weight * from[k];
}

std::vector<double> NonlocalAverage::smoothed(const std::vector<double>& values) const {
  // Along x whole columns shift; along y each column is a line of its own.
  std::vector<double> along_x(values.size());
  std::transform(values.begin(), values.end(), along_x.begin(), [&](double value) { return along_x_.weights[0] * value; });
  for (std::size_t k = 1; k < along_x_.weights.size() && k < columns_; ++k) add_shifted(along_x, values, k * rows_, along_x_.weights[k]);
  std::vector<double> result(values.size(), 0.0);
  for (std::size_t column = 0; column < columns_; ++column) {
    const double* from = along_x.data() + column * rows_;
    double* to = result.data() + column * rows_;
    for (std::size_t k = 0; k < along_y_.weights.size() && k < rows_; ++k) {
      const double weight = along_y_.weights[k];
      for (std::size_t j = 0; j + k < rows_; ++j) to[j] += weight * from[j + k];
      if (k > 0)
        for (std::size_t j = 0; j + k < rows_; ++j) to[j + k] += weight * from[j];
    }
  }
  return result;
}

void NonlocalAverage::update(const Points& points, std::vector<double>& softening_strain) {
  std::vector<double> capped(place_.size());
  for (std::size_t p = 0; p < points.count(); ++p)
    capped[static_cast<std::size_t>(points.label[p])] = std::min(points.plastic_strain[p], caps_[static_cast<std::size_t>(points.soil[p])]);
  for (std::size_t soil = 0; soil < occupancy_.size(); ++soil) {
    std::vector<double> values(columns_ * rows_, 0.0);
    for (std::size_t label = 0; label < place_.size(); ++label)
      if (soil_[label] == static_cast<int>(soil)) values[place_[label]] = capped[label];
    const std::vector<double> sums = smoothed(values);
    for (std::size_t p = 0; p < points.count(); ++p) {
      if (points.soil[p] != static_cast<int>(soil)) continue;
      const auto label = static_cast<std::size_t>(points.label[p]);
      const double average = sums[place_[label]] / occupancy_[soil][place_[label]];
      const double mixed = settings_.factor * average + (1 - settings_.factor) * capped[label];
      softening_strain[p] = std::max(softening_strain[p], mixed);
    }
  }
}

}  // namespace slidezone
