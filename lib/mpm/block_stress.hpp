// Stress, volume and position of a block's points. Written as plain loops over points, which the compiler turns into vector
// instructions: a new soil model goes into soil/ and is called here. Included by sweeps.cpp alone.
#pragma once

#include <type_traits>

#include "mpm/block_weights.hpp"
#include "mpm/row.hpp"
#include "mpm/sweeps.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// Velocity gradient, 1/s: xy is the derivative of v_x along y.
template <class Real>
struct Gradient {
  Real xx, yx, xy, yy;
};
template <class Real>
using BlockGradients = Gradient<Real>[block_size];

template <class Real>
struct Increment {
  Real xx, yy, xy;  // strain increments; xy is half the engineering shear
  Real spin;        // increment of rotation, (dv_x/dy - dv_y/dx) dt / 2
};

/// Jaumann rate and elastic trial stress.
template <class Real>
[[gnu::always_inline]] inline StressOf<Real> trial_stress(StressOf<Real> old, Increment<Real> strain, Real K, Real G) {
  const Real volumetric = strain.xx + strain.yy;
  const Real lambda = K - Real{2} / 3 * G;
  return {old.xx + lambda * volumetric + 2 * G * strain.xx + 2 * strain.spin * old.xy,
          old.yy + lambda * volumetric + 2 * G * strain.yy - 2 * strain.spin * old.xy, old.zz + lambda * volumetric,
          old.xy + 2 * G * strain.xy + strain.spin * (old.yy - old.xx)};
}

struct StressUpdate {
  double internal_work;
  bool is_broken;
};

/// The soil of point p; without layers the same for all, so that its constants stay in registers.
template <SoilTraits traits, class Real>
[[gnu::always_inline]] inline const SoilConstantsOf<Real>& soil_of_point(const SoilConstantsOf<Real>* soils, const int* soil_of, int p) {
  return traits.has_layers ? soils[soil_of[p]] : soils[0];
}

/// The yield surfaces of a block's points. A loop of its own: exp is one long chain, and eight points' chains run at once here that
/// would wait for the stresses below.
template <class Real>
struct BlockYield {
  Real q_phi[block_size], k_c[block_size], tension[block_size];
};

template <SoilTraits traits, class Real>
[[gnu::always_inline]] inline void find_yield(const SweepData<Real>& data, auto block, BlockYield<Real>& yield) {
  const Real* softening_strain = data.softening_strain + block.first;
  const Real* peak_cohesion = data.peak_cohesion + block.first;
  const int* soil_of = data.soil + block.first;
  const SoilConstantsOf<Real>* soils = data.soils;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const YieldSurfaceOf<Real> surface =
        yield_surface<traits>(soil_of_point<traits>(soils, soil_of, p), peak_cohesion[p], softening_strain[p]);
    yield.q_phi[p] = surface.q_phi;
    yield.k_c[p] = surface.k_c;
    yield.tension[p] = surface.tension;
  }
}

/// Sums are doubles whatever the numbers are: a run sums up more of them than a float has digits for.
template <class Real>
[[gnu::always_inline]] inline double block_sum(auto block, Real (&values)[block_size]) {
  for (int p = block.count; p < block_size; ++p) values[p] = 0;
  Row<Real> sums{};
  for (int p = 0; p < block_size; p += 8) sums = sums + Row<Real>::load(values + p);
  Real lane[8];
  sums.store(lane);
  return static_cast<double>(((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7])));
}

template <SoilTraits traits, class Real>
[[gnu::always_inline]] inline StressUpdate update_stress(const SweepData<Real>& data, auto block, const BlockGradients<Real>& gradients) {
  using Flag = std::conditional_t<std::is_same_v<Real, double>, long, int>;  // as wide as a number, so that both fill the same vector
  constexpr Real half = 0.5;
  Real* xx = data.xx + block.first;
  Real* yy = data.yy + block.first;
  Real* zz = data.zz + block.first;
  Real* xy = data.xy + block.first;
  Real* volume = data.volume + block.first;
  Real* plastic_strain = data.plastic_strain + block.first;
  const int* soil_of = data.soil + block.first;
  const SoilConstantsOf<Real>* soils = data.soils;
  const Real step = static_cast<Real>(data.step);
  BlockYield<Real> yield;
  find_yield<traits>(data, block, yield);
  Real work[block_size];  // summed below: a sum inside the loop would keep it from becoming vector instructions
  Flag broken = 0;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const SoilConstantsOf<Real>& soil = soil_of_point<traits>(soils, soil_of, p);
    const Increment<Real> strain{gradients[p].xx * step, gradients[p].yy * step, half * (gradients[p].xy + gradients[p].yx) * step,
                                 half * (gradients[p].xy - gradients[p].yx) * step};
    const StressOf<Real> old{xx[p], yy[p], zz[p], xy[p]};
    StressOf<Real> now = trial_stress(old, strain, soil.bulk, soil.shear);
    plastic_strain[p] += return_to_yield<traits>(now, soil, {yield.q_phi[p], yield.k_c[p], yield.tension[p]});
    work[p] = volume[p] * half * ((old.xx + now.xx) * strain.xx + (old.yy + now.yy) * strain.yy + 2 * (old.xy + now.xy) * strain.xy);
    volume[p] *= 1 + strain.xx + strain.yy;
    broken |= volume[p] > 0 ? Flag{0} : Flag{1};
    xx[p] = now.xx;
    yy[p] = now.yy;
    zz[p] = now.zz;
    xy[p] = now.xy;
  }
  return {block_sum(block, work), broken != 0};
}

template <class Real>
[[gnu::always_inline]] inline void move(const SweepData<Real>& data, auto block) {
  double* x = data.x + block.first;
  double* y = data.y + block.first;
  const Real* movement = data.movement + 2 * block.first;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    x[p] += static_cast<double>(movement[2 * p]);
    y[p] += static_cast<double>(movement[2 * p + 1]);
  }
}

}  // namespace
}  // namespace slidezone
