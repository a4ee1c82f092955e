// From the nodes to the points of a block: velocity gradients, and the points' new velocities. Included by sweeps.cpp alone.
#pragma once

#include "mpm/block_rows.hpp"
#include "mpm/block_stress.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// The three rows of node values that a point reaches, as differences along x, for the same weights give
///   sum N v = v_0 + s (v_1 - v_0) + q (v_2 - 2 v_1 + v_0),    sum h dN/dx v = (v_1 - v_0) + r (v_2 - 2 v_1 + v_0).
template <class Real>
struct Stencil {
  Row<Real> value, first, second;
};

template <class Real>
[[gnu::always_inline]] inline Stencil<Real> stencil(const Real* node_pairs, int base, std::size_t rows) {
  const Real* from = node_pairs + 2 * static_cast<std::size_t>(base);
  const Row<Real> column_0 = Row<Real>::load(from);
  const Row<Real> column_1 = Row<Real>::load(from + 2 * rows);
  const Row<Real> column_2 = Row<Real>::load(from + 4 * rows);
  const Row<Real> first = column_1 - column_0;
  return {column_0, first, (column_2 - column_1) - first};
}

template <class Real>
[[gnu::always_inline]] inline Row<Real> values_along_x(Stencil<Real> nodes, Real s, Real q) {
  return fused(q, nodes.second, fused(s, nodes.first, nodes.value));
}
template <class Real>
[[gnu::always_inline]] inline Row<Real> slopes_along_x(Stencil<Real> nodes, Real r) {
  return fused(r, nodes.second, nodes.first);
}

template <class Real>
[[gnu::always_inline]] inline void gather_gradients(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                    BlockGradients<Real>& gradients) {
  const Real per_x = static_cast<Real>(1 / data.grid.cell_x);
  const Real per_y = static_cast<Real>(1 / data.grid.cell_y);
  const Real scale[4] = {per_x, per_x, per_y, per_y};
  const Pairs<Real> per_length = Pairs<Real>::load(scale);
  const Real* node_velocity = data.node_new_velocity;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  int base = weights.base[0];
  Stencil<Real> velocity = stencil(node_velocity, base, rows);
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      base = weights.base[p];
      velocity = stencil(node_velocity, base, rows);
    }
    const Row<Real> along_x = slopes_along_x(velocity, weights.r_x[p]) * row_values(weights.s_y[p], weights.q_y[p]);
    const Row<Real> along_y = values_along_x(velocity, weights.s_x[p], weights.q_x[p]) * row_slopes(weights.r_y[p]);
    (per_length * sums_over_nodes(along_x, along_y)).store(&gradients[p].xx);
  }
}

/// Pairs (x, y) point after point.
template <class Real>
using BlockPairs = Real[2 * block_size];

/// What a point gets from the nodes: sum N dv and sum N v, m/s.
template <class Real>
struct FromNodes {
  Real change_x, change_y, moving_x, moving_y;
};

template <class Real>
[[gnu::always_inline]] inline void gather_velocities(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                     FromNodes<Real> (&from_nodes)[block_size]) {
  const Real* node_velocity = data.node_velocity;
  const Real* node_change = data.node_change;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  int base = weights.base[0];
  Stencil<Real> change = stencil(node_change, base, rows);
  Stencil<Real> moving = stencil(node_velocity, base, rows);
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      base = weights.base[p];
      change = stencil(node_change, base, rows);
      moving = stencil(node_velocity, base, rows);
    }
    const Real s_x = weights.s_x[p];
    const Real q_x = weights.q_x[p];
    const Row<Real> values_y = row_values(weights.s_y[p], weights.q_y[p]);
    sums_over_nodes(values_along_x(change, s_x, q_x) * values_y, values_along_x(moving, s_x, q_x) * values_y)
        .store(&from_nodes[p].change_x);
  }
}

/// v += sum N dv, drawn by grid_part towards sum N v; movement = dt sum N v. Returns the energy that the drawing took.
template <class Real>
[[gnu::always_inline]] inline double update_velocities(const SweepData<Real>& data, auto block,
                                                       const FromNodes<Real> (&from_nodes)[block_size], BlockPairs<Real>& momentum) {
  Real* velocity = data.velocity + 2 * block.first;
  Real* movement = data.movement + 2 * block.first;
  const Real* mass = data.mass + block.first;
  const Real step = static_cast<Real>(data.step);
  const Real grid_part = static_cast<Real>(data.grid_part);
  constexpr Real half = 0.5;
  Real damped[block_size];
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const FromNodes<Real>& from = from_nodes[p];
    const Real free_x = velocity[2 * p] + from.change_x;
    const Real free_y = velocity[2 * p + 1] + from.change_y;
    const Real now_x = free_x + grid_part * (from.moving_x - free_x);
    const Real now_y = free_y + grid_part * (from.moving_y - free_y);
    damped[p] = half * mass[p] * (free_x * free_x + free_y * free_y - now_x * now_x - now_y * now_y);
    velocity[2 * p] = now_x;
    velocity[2 * p + 1] = now_y;
    movement[2 * p] = step * from.moving_x;
    movement[2 * p + 1] = step * from.moving_y;
    momentum[2 * p] = mass[p] * now_x;
    momentum[2 * p + 1] = mass[p] * now_y;
  }
  return block_sum(block, damped);
}

}  // namespace
}  // namespace slidezone
