#include "mpm/nonlocal_softening.hpp"

#include <algorithm>
#include <cmath>

#include "core/vector_loop.hpp"

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

template <class Real>
NonlocalAverage::NonlocalAverage(const PointsOf<Real>& points, const std::vector<Material>& soils, double spacing_x, double spacing_y,
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

SLIDEZONE_VECTOR_LOOP static void add_scaled(double* to, const double* from, std::size_t count, double weight) {
#pragma GCC ivdep
  for (std::size_t k = 0; k < count; ++k) to[k] += weight * from[k];
}

/// Adds to a line of places each weight times the values that many `stride`s away, both ways.
static void smooth_line(double* to, const double* from, std::size_t length, const std::vector<double>& weights, std::size_t stride) {
  add_scaled(to, from, length, weights[0]);
  for (std::size_t k = 1; k < weights.size() && k * stride < length; ++k) {
    const std::size_t count = length - k * stride;
    add_scaled(to, from + k * stride, count, weights[k]);
    add_scaled(to + k * stride, from, count, weights[k]);
  }
}

std::vector<double> NonlocalAverage::smoothed(const std::vector<double>& values) const {
  // Along x whole columns shift; along y each column is a line of its own.
  std::vector<double> along_x(values.size(), 0.0);
  smooth_line(along_x.data(), values.data(), values.size(), along_x_.weights, rows_);
  std::vector<double> result(values.size(), 0.0);
  for (std::size_t column = 0; column < columns_; ++column)
    smooth_line(result.data() + column * rows_, along_x.data() + column * rows_, rows_, along_y_.weights, 1);
  return result;
}

template <class Real>
void NonlocalAverage::update(const PointsOf<Real>& points, PointNumbers<Real>& softening_strain) {
  std::vector<double> capped(place_.size());
  for (std::size_t p = 0; p < points.count(); ++p)
    capped[static_cast<std::size_t>(points.label[p])] =
        std::min<double>(points.plastic_strain[p], caps_[static_cast<std::size_t>(points.soil[p])]);
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
      softening_strain[p] = std::max(softening_strain[p], static_cast<Real>(mixed));
    }
  }
}

template NonlocalAverage::NonlocalAverage(const PointsOf<double>&, const std::vector<Material>&, double, double, NonlocalSoftening);
template NonlocalAverage::NonlocalAverage(const PointsOf<float>&, const std::vector<Material>&, double, double, NonlocalSoftening);
template void NonlocalAverage::update(const PointsOf<double>&, PointNumbers<double>&);
template void NonlocalAverage::update(const PointsOf<float>&, PointNumbers<float>&);

}  // namespace slidezone
