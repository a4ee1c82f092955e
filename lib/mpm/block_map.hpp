// From the points of a block to the nodes: mass, momentum and internal force. Included by sweeps.cpp alone.
#pragma once

#include "mpm/block_nodes.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// Momentum m v and mass, to the nodes.
template <class Real, class Meanwhile = DoNothing>
[[gnu::always_inline]] inline void map_mass_and_momentum(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                         Meanwhile meanwhile = {}) {
  const Real* velocity = data.velocity + 2 * block.first;
  const Real* mass = data.mass + block.first;
  give_to_nodes<MomentumSums<Real>>(
      block, weights.first_node, data.node_sums,
      data.storage.rows, [&](int p, auto& sums) __attribute__((always_inline)) { sums.add(weights, p, velocity + 2 * p, mass[p]); },
      meanwhile);
}

/// In-plane stresses of a block's points, as the nodes feel them.
template <class Real>
struct BlockStress {
  const Real *xx, *yy, *xy;
};

template <class Real>
[[gnu::always_inline]] inline BlockStress<Real> stress_of(const SweepData<Real>& data, auto block) {
  return {data.xx + block.first, data.yy + block.first, data.xy + block.first};
}

/// Internal force of a block's points, -V stress . grad N, as pairs that go by the slopes of N.
template <class Real>
struct BlockForce {
  BlockPairs<Real> by_x, by_y;  // -V / h_x (s_xx, s_xy), -V / h_y (s_xy, s_yy)
};

template <class Real>
[[gnu::always_inline]] inline void find_force(const SweepData<Real>& data, auto block, BlockStress<Real> stress, BlockForce<Real>& force) {
  const Real* volume = data.volume + block.first;
  const Real per_x = static_cast<Real>(1 / data.grid.cell_x);
  const Real per_y = static_cast<Real>(1 / data.grid.cell_y);
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const Real along_x = -volume[p] * per_x;
    const Real along_y = -volume[p] * per_y;
    force.by_x[2 * p] = along_x * stress.xx[p];
    force.by_x[2 * p + 1] = along_x * stress.xy[p];
    force.by_y[2 * p] = along_y * stress.xy[p];
    force.by_y[2 * p + 1] = along_y * stress.yy[p];
  }
}

/// Internal force, to the nodes.
template <class Real>
[[gnu::always_inline]] inline void map_force(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                             BlockStress<Real> stress) {
  BlockForce<Real> force;
  find_force(data, block, stress, force);
  give_to_nodes<SlopeSums<Real>>(
      block, weights.first_node, data.node_force, data.storage.rows, [&](int p, auto& sums) __attribute__((always_inline)) {
        sums.add(weights, p, force.by_x + 2 * p, force.by_y + 2 * p);
      });
}

/// Momentum, mass and internal force, to the nodes.
template <class Real>
[[gnu::always_inline]] inline void map_all(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                           BlockStress<Real> stress) {
  Ahead ahead;
  if (data.fetches_ahead) {
    ahead.add(data.xy + block.first);
    ahead.add(data.volume + block.first);
    for (const double* place : {data.x, data.y}) ahead.add(place + block.first);
    for (const Real* pairs : {data.movement, data.velocity}) ahead.add(pairs + 2 * block.first, 2);
    ahead.add(data.mass + block.first);
  }
  const auto fetch = [&]() __attribute__((always_inline)) { ahead.fetch_some(); };
  if constexpr (eight_fit<Real>) {
    const Real* velocity = data.velocity + 2 * block.first;
    const Real* mass = data.mass + block.first;
    Real mass_of_third[block_size];
    BlockForce<Real> force;
    find_force(data, block, stress, force);
#pragma GCC ivdep
    for (int p = 0; p < block.count; ++p) mass_of_third[p] = mass[p] * weights.q_y[p];
    using Sums = MomentumAndForceSums<Real>;
    give_to_nodes<Sums>(
        block, weights.first_node, typename Sums::Target{data.node_sums, data.node_force}, data.storage.rows,
        [&](int p, auto& sums) __attribute__((always_inline)) {
          sums.add(weights, p, velocity + 2 * p, mass[p], mass_of_third[p], force.by_x + 2 * p, force.by_y + 2 * p);
        },
        fetch);
  } else {
    map_mass_and_momentum(data, block, weights, fetch);
    map_force(data, block, weights, stress);
  }
  ahead.fetch_rest();
}

}  // namespace
}  // namespace slidezone
