// Stress, volume and position of a block's points. Written as plain loops over points, which the compiler turns into vector
// instructions: a new soil model goes into soil/ and is called here. Included by sweeps.cpp alone.
#pragma once

#include <type_traits>

#include "mpm/block_weights.hpp"
#include "mpm/lanes.hpp"
#include "mpm/sweeps.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// Velocity gradients, 1/s: xy is the derivative of v_x along y.
template <class Real>
struct BlockGradients {
  Real xx[block_size], yx[block_size], xy[block_size], yy[block_size];
};

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

/// The soils of a block's points; without layers a copy of the only one, whose constants stay in registers.
template <SoilTraits traits, class Real>
struct BlockSoils {
  const SoilConstantsOf<Real>* soils;
  const int* soil_of;

  [[gnu::always_inline]] const SoilConstantsOf<Real>& operator[](int p) const { return soils[soil_of[p]]; }
};
template <SoilTraits traits, class Real>
requires(!traits.has_layers) struct BlockSoils<traits, Real> {
  SoilConstantsOf<Real> soil;

  BlockSoils(const SoilConstantsOf<Real>* soils, const int*) : soil(*soils) {}
  [[gnu::always_inline]] const SoilConstantsOf<Real>& operator[](int) const { return soil; }
};

// What follows is a loop for each of some parts of the stress update. In one loop each point's numbers would wait for one another along
// one long chain, exp, square root, quotient, and the processor sees only a few points at a time.

/// The yield surfaces of a block's points.
template <class Real>
struct BlockYield {
  Real q_phi[block_size], k_c[block_size], tension[block_size];
};

template <SoilTraits traits, class Real>
[[gnu::always_inline]] inline void find_yield(const SweepData<Real>& data, auto block, const BlockSoils<traits, Real>& soils,
                                              BlockYield<Real>& yield) {
  const Real* softening_strain = data.softening_strain + block.first;
  const Real* peak_cohesion = data.peak_cohesion + block.first;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const YieldSurfaceOf<Real> surface = yield_surface<traits>(soils[p], peak_cohesion[p], softening_strain[p]);
    yield.q_phi[p] = surface.q_phi;
    yield.k_c[p] = surface.k_c;
    yield.tension[p] = surface.tension;
  }
}

/// Strain increments and elastic trial stresses of a block's points.
template <class Real>
struct BlockTrial {
  Real strain_xx[block_size], strain_yy[block_size], strain_xy[block_size];
  Real xx[block_size], yy[block_size], zz[block_size], xy[block_size];
  Real mean[block_size], j2[block_size];
};

template <SoilTraits traits, class Real>
[[gnu::always_inline]] inline void try_elastic(const SweepData<Real>& data, auto block, const BlockSoils<traits, Real>& soils,
                                               const BlockGradients<Real>& gradients, BlockTrial<Real>& trial) {
  constexpr Real half = 0.5;
  const Real* xx = data.xx + block.first;
  const Real* yy = data.yy + block.first;
  const Real* zz = data.zz + block.first;
  const Real* xy = data.xy + block.first;
  const Real step = static_cast<Real>(data.step);
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const SoilConstantsOf<Real>& soil = soils[p];
    const Increment<Real> strain{gradients.xx[p] * step, gradients.yy[p] * step, half * (gradients.xy[p] + gradients.yx[p]) * step,
                                 half * (gradients.xy[p] - gradients.yx[p]) * step};
    const StressOf<Real> stress = trial_stress({xx[p], yy[p], zz[p], xy[p]}, strain, soil.bulk, soil.shear);
    const InvariantsOf<Real> of_stress = invariants(stress);
    trial.strain_xx[p] = strain.xx;
    trial.strain_yy[p] = strain.yy;
    trial.strain_xy[p] = strain.xy;
    trial.xx[p] = stress.xx;
    trial.yy[p] = stress.yy;
    trial.zz[p] = stress.zz;
    trial.xy[p] = stress.xy;
    trial.mean[p] = of_stress.mean;
    trial.j2[p] = of_stress.j2;
  }
}

/// Shear stresses of a block's points: at once where the processor estimates roots, one by one elsewhere.
template <class Block, class Real>
struct BlockShear {
  const Real* j2;

  [[gnu::always_inline]] ShearOf<Real> operator[](int p) const { return shear_of(j2[p]); }
};
#if SLIDEZONE_REGISTER_BYTES == 64
template <class Real>
struct BlockShear<FullBlock, Real> {
  Real tau[block_size], inverse[block_size];

  [[gnu::always_inline]] explicit BlockShear(const Real* j2) {
    using Register = Lanes<Real, register_bytes / static_cast<int>(sizeof(Real))>;
    for (int p = 0; p < block_size; p += Register::size) {
      const auto [root, inverse_root] = root_and_inverse(Register::load(j2 + p));
      root.store(tau + p);
      inverse_root.store(inverse + p);
    }
  }
  [[gnu::always_inline]] ShearOf<Real> operator[](int p) const { return {tau[p], inverse[p]}; }
};
#endif

/// Ways back to the yield surface.
template <class Real>
struct BlockReturn {
  Real kept[block_size], mean[block_size];
};

template <SoilTraits traits, class Real>
[[gnu::always_inline]] inline void flow(const SweepData<Real>& data, auto block, const BlockSoils<traits, Real>& soils,
                                        const BlockYield<Real>& yield, const BlockTrial<Real>& trial, BlockReturn<Real>& back) {
  Real* plastic_strain = data.plastic_strain + block.first;
  const BlockShear<decltype(block), Real> shear{trial.j2};
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const ReturnOf<Real> way = way_back<traits>(trial.mean[p], shear[p], soils[p], {yield.q_phi[p], yield.k_c[p], yield.tension[p]});
    back.kept[p] = way.kept;
    back.mean[p] = way.mean;
    plastic_strain[p] += way.plastic_strain;
  }
}

/// Sums are doubles whatever the numbers are: a run sums up more of them than a float has digits for.
template <class Real>
[[gnu::always_inline]] inline double block_sum(auto block, Real (&values)[block_size]) {
  for (int p = block.count; p < block_size; ++p) values[p] = 0;
  Four<Real> sums[2]{};
  for (int p = 0; p < block_size; p += 8)
    for (int k = 0; k < 2; ++k) sums[k] = sums[k] + Four<Real>::load(values + p + 4 * k);
  Real lane[4];
  (sums[0] + sums[1]).store(lane);
  return static_cast<double>((lane[0] + lane[1]) + (lane[2] + lane[3]));
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
  const BlockSoils<traits, Real> soils(data.soils, data.soil + block.first);
  BlockYield<Real> yield;
  BlockTrial<Real> trial;
  BlockReturn<Real> back;
  find_yield(data, block, soils, yield);
  try_elastic(data, block, soils, gradients, trial);
  flow(data, block, soils, yield, trial, back);
  Real work[block_size];  // summed below: a sum inside the loop would keep it from becoming vector instructions
  Flag broken = 0;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const StressOf<Real> now =
        returned({trial.xx[p], trial.yy[p], trial.zz[p], trial.xy[p]}, trial.mean[p], ReturnOf<Real>{back.kept[p], back.mean[p], 0});
    work[p] = volume[p] * half *
              ((xx[p] + now.xx) * trial.strain_xx[p] + (yy[p] + now.yy) * trial.strain_yy[p] + 2 * (xy[p] + now.xy) * trial.strain_xy[p]);
    volume[p] *= 1 + trial.strain_xx[p] + trial.strain_yy[p];
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
