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
  Real* node_sums = data.node_sums;
  const std::ptrdiff_t rows = data.storage.rows;
  const Real one[2] = {1, 0};
  const Pair<Real> of_mass = Pair<Real>::load(one);
  ValueSums<Real, 4> sums;
  sum_points(
      block, weights.first_node,
      [&](int p) __attribute__((always_inline)) {
        sums.add(weights.s_x[p], weights.q_x[p], weights.s_y[p], weights.q_y[p],
                 mass[p] * both(Pair<Real>::load(velocity + 2 * p), of_mass));
      },
      [&](int node) __attribute__((always_inline)) { sums.give(node_sums, node, rows); });
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
  Real* node_force = data.node_force;
  const std::ptrdiff_t rows = data.storage.rows;
  const Real per_x = static_cast<Real>(1 / data.grid.cell_x);
  const Real per_y = static_cast<Real>(1 / data.grid.cell_y);
  Real by_y_x[block_size], by_y_y[block_size], by_x_x[block_size], by_x_y[block_size];  // -V / h_y (s_xy, s_yy), -V / h_x (s_xx, s_xy)
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const Real force_x = -volume[p] * per_x;
    const Real force_y = -volume[p] * per_y;
    by_y_x[p] = force_y * stress.xy[p];
    by_y_y[p] = force_y * stress.yy[p];
    by_x_x[p] = force_x * stress.xx[p];
    by_x_y[p] = force_x * stress.xy[p];
  }
  BlockFours<Real> gifts;
  interleave(block, by_y_x, by_y_y, by_x_x, by_x_y, gifts);
  SlopeSums<Real> sums;
  sum_points(
      block, weights.first_node,
      [&](int p) __attribute__((always_inline)) { sums.add(slope_weights(weights, p), Four<Real>::load(gifts + 4 * p)); },
      [&](int node) __attribute__((always_inline)) { sums.give(node_force, node, rows); });
}

/// Momentum of moved points to the nodes, for the second time in a step.
template <class Real>
[[gnu::always_inline]] inline void map_new_momentum(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                    const BlockPairs<Real>& momentum) {
  Real* node_new_momentum = data.node_new_momentum;
  const std::ptrdiff_t rows = data.storage.rows;
  ValueSums<Real, 2> sums;
  sum_points(
      block, weights.first_node,
      [&](int p) __attribute__((always_inline)) {
        sums.add(weights.s_x[p], weights.q_x[p], weights.s_y[p], weights.q_y[p], Pair<Real>::load(momentum + 2 * p));
      },
      [&](int node) __attribute__((always_inline)) { sums.give(node_new_momentum, node, rows); });
}

}  // namespace
}  // namespace slidezone
