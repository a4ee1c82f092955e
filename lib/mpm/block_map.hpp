// From the points of a block to the nodes: mass, momentum and internal force. Included by sweeps.cpp alone.
#pragma once

#include "mpm/block_nodes.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// Momentum m v and mass, to the nodes.
template <class Real>
[[gnu::always_inline]] inline void map_mass_and_momentum(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights) {
  const Real* velocity = data.velocity + 2 * block.first;
  const Real* mass = data.mass + block.first;
  give_to_nodes<MomentumSums<Real>>(
      block, weights.first_node, data.node_sums,
      data.storage.rows, [&](int p, auto& sums) __attribute__((always_inline)) { sums.add(weights, p, velocity + 2 * p, mass[p]); });
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

/// Internal force -V stress . grad N, to the nodes.
template <class Real>
[[gnu::always_inline]] inline void map_force(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                             BlockStress<Real> stress) {
  const Real* volume = data.volume + block.first;
  const Real per_x = static_cast<Real>(1 / data.grid.cell_x);
  const Real per_y = static_cast<Real>(1 / data.grid.cell_y);
  BlockPairs<Real> by_x, by_y;  // -V / h_x (s_xx, s_xy), -V / h_y (s_xy, s_yy)
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const Real force_x = -volume[p] * per_x;
    const Real force_y = -volume[p] * per_y;
    by_x[2 * p] = force_x * stress.xx[p];
    by_x[2 * p + 1] = force_x * stress.xy[p];
    by_y[2 * p] = force_y * stress.xy[p];
    by_y[2 * p + 1] = force_y * stress.yy[p];
  }
  give_to_nodes<SlopeSums<Real>>(
      block, weights.first_node, data.node_force,
      data.storage.rows, [&](int p, auto& sums) __attribute__((always_inline)) { sums.add(weights, p, by_x + 2 * p, by_y + 2 * p); });
}

/// Momentum of moved points to the nodes, for the second time in a step.
template <class Real>
[[gnu::always_inline]] inline void map_new_momentum(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                    const BlockPairs<Real>& momentum) {
  give_to_nodes<PairSums<Real>>(
      block, weights.first_node, data.node_new_momentum,
      data.storage.rows, [&](int p, auto& sums) __attribute__((always_inline)) { sums.add(weights, p, momentum + 2 * p); });
}

}  // namespace
}  // namespace slidezone
