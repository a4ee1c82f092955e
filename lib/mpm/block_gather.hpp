// From the nodes to the points of a block: velocity gradients, and the points' new velocities. Included by sweeps.cpp alone.
#pragma once

#include "mpm/block_rows.hpp"
#include "mpm/block_stress.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// The three rows of node values that a point reaches, as differences along x, for the same weights give
///   sum N v = v_0 + s (v_1 - v_0) + q (v_2 - 2 v_1 + v_0),    sum h dN/dx v = (v_1 - v_0) + r (v_2 - 2 v_1 + v_0).
struct Stencil {
  Row value, first, second;
};

[[gnu::always_inline]] inline Stencil stencil(const double* node_pairs, int base, std::size_t rows) {
  const double* from = node_pairs + 2 * static_cast<std::size_t>(base);
  const Row column_0 = Row::load(from);
  const Row column_1 = Row::load(from + 2 * rows);
  const Row column_2 = Row::load(from + 4 * rows);
  const Row first = column_1 - column_0;
  return {column_0, first, (column_2 - column_1) - first};
}

[[gnu::always_inline]] inline Row values_along_x(Stencil nodes, double s, double q) {
  return fused(q, nodes.second, fused(s, nodes.first, nodes.value));
}
[[gnu::always_inline]] inline Row slopes_along_x(Stencil nodes, double r) { return fused(r, nodes.second, nodes.first); }

[[gnu::always_inline]] inline void gather_gradients(const SweepData& data, auto block, const BlockWeights& weights,
                                                    BlockGradients& gradients) {
  const double scale[4] = {1 / data.grid.cell_x, 1 / data.grid.cell_x, 1 / data.grid.cell_y, 1 / data.grid.cell_y};
  const Pairs per_length = Pairs::load(scale);
  const double* node_velocity = data.node_new_velocity;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  int base = weights.base[0];
  Stencil velocity = stencil(node_velocity, base, rows);
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      base = weights.base[p];
      velocity = stencil(node_velocity, base, rows);
    }
    const Row along_x = slopes_along_x(velocity, weights.r_x[p]) * row_values(weights.s_y[p], weights.q_y[p]);
    const Row along_y = values_along_x(velocity, weights.s_x[p], weights.q_x[p]) * row_slopes(weights.r_y[p]);
    (per_length * sums_over_nodes(along_x, along_y)).store(&gradients[p].xx);
  }
}

/// Pairs (x, y) point after point.
using BlockPairs = double[2 * block_size];

/// What a point gets from the nodes: sum N dv and sum N v, m/s.
struct FromNodes {
  double change_x, change_y, moving_x, moving_y;
};

[[gnu::always_inline]] inline void gather_velocities(const SweepData& data, auto block, const BlockWeights& weights,
                                                     FromNodes (&from_nodes)[block_size]) {
  const double* node_velocity = data.node_velocity;
  const double* node_change = data.node_change;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  int base = weights.base[0];
  Stencil change = stencil(node_change, base, rows);
  Stencil moving = stencil(node_velocity, base, rows);
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      base = weights.base[p];
      change = stencil(node_change, base, rows);
      moving = stencil(node_velocity, base, rows);
    }
    const double s_x = weights.s_x[p];
    const double q_x = weights.q_x[p];
    const Row values_y = row_values(weights.s_y[p], weights.q_y[p]);
    sums_over_nodes(values_along_x(change, s_x, q_x) * values_y, values_along_x(moving, s_x, q_x) * values_y)
        .store(&from_nodes[p].change_x);
  }
}

/// v += sum N dv, drawn by grid_part towards sum N v; movement = dt sum N v. Returns the energy that the drawing took.
[[gnu::always_inline]] inline double update_velocities(const SweepData& data, auto block, const FromNodes (&from_nodes)[block_size],
                                                       BlockPairs& momentum) {
  double* velocity = data.velocity + 2 * block.first;
  double* movement = data.movement + 2 * block.first;
  const double* mass = data.mass + block.first;
  const double step = data.step;
  const double grid_part = data.grid_part;
  double damped[block_size] = {};
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const FromNodes& from = from_nodes[p];
    const double free_x = velocity[2 * p] + from.change_x;
    const double free_y = velocity[2 * p + 1] + from.change_y;
    const double now_x = free_x + grid_part * (from.moving_x - free_x);
    const double now_y = free_y + grid_part * (from.moving_y - free_y);
    damped[p] = 0.5 * mass[p] * (free_x * free_x + free_y * free_y - now_x * now_x - now_y * now_y);
    velocity[2 * p] = now_x;
    velocity[2 * p + 1] = now_y;
    movement[2 * p] = step * from.moving_x;
    movement[2 * p + 1] = step * from.moving_y;
    momentum[2 * p] = mass[p] * now_x;
    momentum[2 * p + 1] = mass[p] * now_y;
  }
  return block_sum(damped);
}

}  // namespace
}  // namespace slidezone
