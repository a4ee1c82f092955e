// Bodies that the tests of lib/mpm share. SI units; a cell is 0.2 m and holds 2 x 2 points.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mpm/simulation.hpp"

namespace slidezone {

/// A block of points from (x, y), `columns` x `rows` cells of 0.2 m with 2 x 2 points each, in a grid of 40 x 20 cells.
inline Model block(double x, double y, int columns, int rows, const Material& soil) {
  Model model;
  model.grid = {0.2, 0.2, 40, 20};
  model.point_spacing_x = model.point_spacing_y = 0.1;
  model.soils = {soil};
  model.points = points_at_rest(static_cast<std::size_t>(4 * columns * rows));
  std::size_t p = 0;
  for (int i = 0; i < 2 * columns; ++i)
    for (int j = 0; j < 2 * rows; ++j, ++p) {
      model.points.x[p] = x + 0.1 * (i + 0.5);
      model.points.y[p] = y + 0.1 * (j + 0.5);
      model.points.volume[p] = 0.01;
      model.points.mass[p] = 0.01 * soil.density;
      model.points.peak_cohesion[p] = soil.peak_cohesion;
    }
  model.gravity = {{0, -9.81}, GravityProtocol::sudden, 0, {}};
  model.time = {.end = 0.5, .step = {}, .step_fraction = 0.5, .rest = {}};
  return model;
}

inline const Material elastic{.density = 2000, .youngs_modulus = 1e6, .poisson_ratio = 0.3, .peak_cohesion = 1e9, .residual_cohesion = 1e9};
inline const Material clay{.density = 2000,
                           .youngs_modulus = 1e6,
                           .poisson_ratio = 0.33,
                           .peak_cohesion = 5e3,
                           .residual_cohesion = 1e3,
                           .softening_threshold = 0.01,
                           .softening_shape = 8};

inline void throw_all(Model& model, double vx, double vy) {
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    model.points.velocity[2 * p] = vx;
    model.points.velocity[2 * p + 1] = vy;
  }
}

/// A soft block that is squeezed, sheared and turned in free flight.
inline Model deforming_block() {
  Model model = block(3.1, 1.33, 5, 4, clay);
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    const double x = model.points.x[p] - 3.6;
    const double y = model.points.y[p] - 1.7;
    model.points.velocity[2 * p] = 0.3 - 2 * x + 3 * y;
    model.points.velocity[2 * p + 1] = 1 + x + 2 * y;
  }
  model.time.end = 0.3;
  return model;
}

inline double worst_distance(const Points& a, const Points& b) {
  double worst = 0;
  for (std::size_t p = 0; p < a.count(); ++p) worst = std::max(worst, std::hypot(a.x[p] - b.x[p], a.y[p] - b.y[p]));
  return worst;
}

/// The deforming block of a soil that is clay but for what `change` does to it.
template <class Change>
inline Model deforming_block_of(Change change) {
  Model model = deforming_block();
  change(model.soils[0]);
  return model;
}

inline Model in_single_precision(Model model) {
  model.method.precision = Precision::single_precision;
  return model;
}

/// A column of clay of 100,800 points that collapses, thrown to the right so that points change strips.
inline Model large_block(int threads) {
  Model model = block(0, 0, 200, 126, clay);
  model.grid = {0.2, 0.2, 400, 140};
  model.boundaries.base_friction = 0.3;
  throw_all(model, 10, 0);
  model.time.end = 0.4;
  model.threads = threads;
  return model;
}

}  // namespace slidezone
