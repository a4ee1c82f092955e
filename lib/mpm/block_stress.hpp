// Stress, volume and position of a block's points. Written as plain loops over points, which the compiler turns into vector
// instructions: a new soil model goes into soil/ and is called here. Included by sweeps.cpp alone.
#pragma once

#include "mpm/block_weights.hpp"
#include "mpm/row.hpp"
#include "mpm/sweeps.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// Velocity gradient, 1/s: xy is the derivative of v_x along y.
struct Gradient {
  double xx, yx, xy, yy;
};
using BlockGradients = Gradient[block_size];

struct Increment {
  double xx, yy, xy;  // strain increments; xy is half the engineering shear
  double spin;        // increment of rotation, (dv_x/dy - dv_y/dx) dt / 2
};

/// Jaumann rate and elastic trial stress.
[[gnu::always_inline]] inline Stress trial_stress(Stress old, Increment strain, double K, double G) {
  const double volumetric = strain.xx + strain.yy;
  const double lambda = K - 2.0 / 3.0 * G;
  return {old.xx + lambda * volumetric + 2 * G * strain.xx + 2 * strain.spin * old.xy,
          old.yy + lambda * volumetric + 2 * G * strain.yy - 2 * strain.spin * old.xy, old.zz + lambda * volumetric,
          old.xy + 2 * G * strain.xy + strain.spin * (old.yy - old.xx)};
}

struct StressUpdate {
  double internal_work;
  bool is_broken;
};

/// The soil of point p; without layers the same for all, so that its constants stay in registers.
template <SoilTraits traits>
[[gnu::always_inline]] inline const SoilConstants& soil_of_point(const SoilConstants* soils, const int* soil_of, int p) {
  return traits.has_layers ? soils[soil_of[p]] : soils[0];
}

[[gnu::always_inline]] inline double block_sum(const double (&values)[block_size]) {
  Row sums{};
  for (int p = 0; p < block_size; p += 8) sums = sums + Row::load(values + p);
  double lane[8];
  sums.store(lane);
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

template <SoilTraits traits>
[[gnu::always_inline]] inline StressUpdate update_stress(const SweepData& data, auto block, const BlockGradients& gradients) {
  double* xx = data.xx + block.first;
  double* yy = data.yy + block.first;
  double* zz = data.zz + block.first;
  double* xy = data.xy + block.first;
  double* volume = data.volume + block.first;
  double* plastic_strain = data.plastic_strain + block.first;
  const double* softening_strain = data.softening_strain + block.first;
  const double* peak_cohesion = data.peak_cohesion + block.first;
  const int* soil_of = data.soil + block.first;
  const SoilConstants* soils = data.soils;
  const double step = data.step;
  double work[block_size] = {};  // summed below: a sum inside the loop would keep it from becoming vector instructions
  long broken = 0;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const SoilConstants& soil = soil_of_point<traits>(soils, soil_of, p);
    const Increment strain{gradients[p].xx * step, gradients[p].yy * step, 0.5 * (gradients[p].xy + gradients[p].yx) * step,
                           0.5 * (gradients[p].xy - gradients[p].yx) * step};
    const Stress old{xx[p], yy[p], zz[p], xy[p]};
    Stress now = trial_stress(old, strain, soil.bulk, soil.shear);
    const YieldSurface yield = yield_surface<traits>(soil, peak_cohesion[p], softening_strain[p]);
    plastic_strain[p] += return_to_yield<traits>(now, soil, yield);
    work[p] = volume[p] * 0.5 * ((old.xx + now.xx) * strain.xx + (old.yy + now.yy) * strain.yy + 2 * (old.xy + now.xy) * strain.xy);
    volume[p] *= 1 + strain.xx + strain.yy;
    broken |= volume[p] > 0 ? 0L : 1L;
    xx[p] = now.xx;
    yy[p] = now.yy;
    zz[p] = now.zz;
    xy[p] = now.xy;
  }
  return {block_sum(work), broken != 0};
}

[[gnu::always_inline]] inline void move(const SweepData& data, auto block) {
  double* x = data.x + block.first;
  double* y = data.y + block.first;
  const double* movement = data.movement + 2 * block.first;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    x[p] += movement[2 * p];
    y[p] += movement[2 * p + 1];
  }
}

}  // namespace
}  // namespace slidezone
