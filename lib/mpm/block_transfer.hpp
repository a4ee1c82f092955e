// Between the points of a block and the nodes: gather by rows of nodes, map by sums that stay in registers. Included by
// sweeps.cpp alone.
#pragma once

#include "mpm/block_stress.hpp"
#include "mpm/block_weights.hpp"
#include "mpm/row.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

// Along y a row's weights are N = {1 - s + q, s - 2 q, q} and its slopes {r - 1, 1 - 2 r, r}, each for both components, the
// fourth node zero.
alignas(64) constexpr double value_1[8] = {1, 1, 0, 0, 0, 0, 0, 0};
alignas(64) constexpr double value_s[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
alignas(64) constexpr double value_q[8] = {1, 1, -2, -2, 1, 1, 0, 0};
alignas(64) constexpr double slope_1[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
alignas(64) constexpr double mass_1[4] = {1, 0, 0, 0};
alignas(64) constexpr double mass_s[4] = {-1, 1, 0, 0};
alignas(64) constexpr double mass_q[4] = {1, -2, 1, 0};

[[gnu::always_inline]] inline Row row_values(double s, double q) {
  return fused(q, Row::load(value_q), fused(s, Row::load(value_s), Row::load(value_1)));
}
[[gnu::always_inline]] inline Row row_slopes(double r) { return fused(r, Row::load(value_q), Row::load(slope_1)); }
[[gnu::always_inline]] inline MassRow mass_values(double s, double q) {
  return fused(q, MassRow::load(mass_q), fused(s, MassRow::load(mass_s), MassRow::load(mass_1)));
}

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

/// Sums for the nodes of one base while consecutive points share it, in the form of Stencil's differences; given to the nodes
/// when the base changes. Right for any order of points, fast when they are nearly sorted by base.
template <class NodeRow, int lanes_a_node>
struct Accumulator {
  NodeRow sum{};
  NodeRow sum_first{};
  NodeRow sum_second{};

  /// N_x values
  [[gnu::always_inline]] void add_values(double s, double q, NodeRow values) {
    sum = sum + values;
    sum_first = fused(s, values, sum_first);
    sum_second = fused(q, values, sum_second);
  }
  /// h dN_x/dx values
  [[gnu::always_inline]] void add_slopes(double r, NodeRow values) {
    sum_first = sum_first + values;
    sum_second = fused(r, values, sum_second);
  }
  [[gnu::always_inline]] void flush(double* nodes, int base, std::size_t rows) {
    double* to = nodes + lanes_a_node * static_cast<std::size_t>(base);
    const std::size_t next = lanes_a_node * rows;
    const NodeRow rest = sum_first - sum_second;
    (NodeRow::load(to) + (sum - rest)).store(to);
    (NodeRow::load(to + next) + (rest - sum_second)).store(to + next);
    (NodeRow::load(to + 2 * next) + sum_second).store(to + 2 * next);
    *this = {};
  }
};
using PairAccumulator = Accumulator<Row, 2>;
using MassAccumulator = Accumulator<MassRow, 1>;

/// In-plane stresses of a block's points, as the nodes feel them.
struct BlockStress {
  const double *xx, *yy, *xy;
};

[[gnu::always_inline]] inline BlockStress stress_of(const SweepData& data, auto block) {
  return {data.xx + block.first, data.yy + block.first, data.xy + block.first};
}

/// What a point gives to the nodes.
enum class Give { momentum, force, both };

/// Pairs (x, y) point after point.
using BlockPairs = double[2 * block_size];

/// What a block's points give to the nodes.
struct BlockGifts {
  BlockPairs momentum;  // m v
  BlockPairs along_x;   // -V / h_x (s_xx, s_xy)
  BlockPairs along_y;   // -V / h_y (s_xy, s_yy)
};

template <Give give>
[[gnu::always_inline]] inline void prepare_gifts(const SweepData& data, auto block, BlockStress stress, BlockGifts& gifts) {
  const double* velocity = data.velocity + 2 * block.first;
  const double* volume = data.volume + block.first;
  const double* mass = data.mass + block.first;
  const double inverse_x = 1 / data.grid.cell_x;
  const double inverse_y = 1 / data.grid.cell_y;
  if constexpr (give != Give::force) {
#pragma GCC ivdep
    for (int p = 0; p < block.count; ++p) {
      gifts.momentum[2 * p] = mass[p] * velocity[2 * p];
      gifts.momentum[2 * p + 1] = mass[p] * velocity[2 * p + 1];
    }
  }
  if constexpr (give != Give::momentum) {
#pragma GCC ivdep
    for (int p = 0; p < block.count; ++p) {
      const double force_x = -volume[p] * inverse_x;
      const double force_y = -volume[p] * inverse_y;
      gifts.along_x[2 * p] = force_x * stress.xx[p];
      gifts.along_x[2 * p + 1] = force_x * stress.xy[p];
      gifts.along_y[2 * p] = force_y * stress.xy[p];
      gifts.along_y[2 * p + 1] = force_y * stress.yy[p];
    }
  }
}

/// Mass and momentum m v, and internal force -V stress . grad N, to the nodes.
template <Give give>
[[gnu::always_inline]] inline void map_to_nodes(const SweepData& data, auto block, const BlockWeights& weights, BlockStress stress) {
  constexpr bool gives_momentum = give != Give::force;
  constexpr bool gives_force = give != Give::momentum;
  BlockGifts gifts;
  prepare_gifts<give>(data, block, stress, gifts);
  const double* mass = data.mass + block.first;
  double* node_momentum = data.node_momentum;
  double* node_force = data.node_force;
  double* node_mass = data.node_mass;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  PairAccumulator momentum_sums, force_sums;
  MassAccumulator mass_sums;
  int base = weights.base[0];
  const auto flush = [&]() __attribute__((always_inline)) {
    if constexpr (gives_momentum) momentum_sums.flush(node_momentum, base, rows);
    if constexpr (gives_momentum) mass_sums.flush(node_mass, base, rows);
    if constexpr (gives_force) force_sums.flush(node_force, base, rows);
  };
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      flush();
      base = weights.base[p];
    }
    const double s_x = weights.s_x[p];
    const double q_x = weights.q_x[p];
    const Row values_y = row_values(weights.s_y[p], weights.q_y[p]);
    if constexpr (gives_momentum) {
      momentum_sums.add_values(s_x, q_x, values_y * repeated(gifts.momentum + 2 * p));
      mass_sums.add_values(s_x, q_x, mass[p] * mass_values(weights.s_y[p], weights.q_y[p]));
    }
    if constexpr (gives_force) {
      force_sums.add_slopes(weights.r_x[p], values_y * repeated(gifts.along_x + 2 * p));
      force_sums.add_values(s_x, q_x, row_slopes(weights.r_y[p]) * repeated(gifts.along_y + 2 * p));
    }
  }
  flush();
}

enum class SecondMap { yes, no };

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

[[gnu::always_inline]] inline void map_momentum(const SweepData& data, auto block, const BlockWeights& weights,
                                                const BlockPairs& momentum) {
  double* node_new_momentum = data.node_new_momentum;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  PairAccumulator sums;
  int base = weights.base[0];
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      sums.flush(node_new_momentum, base, rows);
      base = weights.base[p];
    }
    sums.add_values(weights.s_x[p], weights.q_x[p], row_values(weights.s_y[p], weights.q_y[p]) * repeated(momentum + 2 * p));
  }
  sums.flush(node_new_momentum, base, rows);
}

/// v += sum N dv, drawn by grid_part towards sum N v; movement = dt sum N v; with the second map also sum N m v to the
/// nodes. Returns the energy that the drawing took.
template <SecondMap second_map>
[[gnu::always_inline]] inline double gather_block(const SweepData& data, auto block, const BlockWeights& weights) {
  FromNodes from_nodes[block_size];
  BlockPairs momentum;
  gather_velocities(data, block, weights, from_nodes);
  const double damped = update_velocities(data, block, from_nodes, momentum);
  if constexpr (second_map == SecondMap::yes) map_momentum(data, block, weights, momentum);
  return damped;
}

}  // namespace
}  // namespace slidezone
