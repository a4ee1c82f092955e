// Between the points of a block and the nodes: gather by rows of nodes, map by sums that stay in registers. Included by
// sweeps.cpp alone.
#pragma once

#include "mpm/block_stress.hpp"
#include "mpm/block_weights.hpp"
#include "mpm/row.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

// A row's weights N = {1 - s + q, s - 2 q, q} and slopes {r - 1, 1 - 2 r, r}, each for both components, the fourth node zero.
alignas(64) constexpr double value_1[8] = {1, 1, 0, 0, 0, 0, 0, 0};
alignas(64) constexpr double value_s[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
alignas(64) constexpr double value_q[8] = {1, 1, -2, -2, 1, 1, 0, 0};
alignas(64) constexpr double slope_1[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
alignas(64) constexpr double mass_1[4] = {1, 0, 0, 0};
alignas(64) constexpr double mass_s[4] = {-1, 1, 0, 0};
alignas(64) constexpr double mass_q[4] = {1, -2, 1, 0};

[[gnu::always_inline]] inline Row row_values(double s, double q) {
  return Row::load(value_1) + s * Row::load(value_s) + q * Row::load(value_q);
}
[[gnu::always_inline]] inline Row row_slopes(double r) { return Row::load(slope_1) + r * Row::load(value_q); }
[[gnu::always_inline]] inline MassRow mass_values(double s, double q) {
  return MassRow::load(mass_1) + s * MassRow::load(mass_s) + q * MassRow::load(mass_q);
}

/// The rows of node values, one pair a node, that a point reaches.
struct Stencil {
  Row column[3];
};

[[gnu::always_inline]] inline Stencil stencil(const double* node_pairs, int base, std::size_t rows) {
  const double* from = node_pairs + 2 * static_cast<std::size_t>(base);
  return {{Row::load(from), Row::load(from + 2 * rows), Row::load(from + 4 * rows)}};
}

[[gnu::always_inline]] inline Row combined(const Stencil& values, const AxisValues& weights) {
  return weights.node[0] * values.column[0] + weights.node[1] * values.column[1] + weights.node[2] * values.column[2];
}

[[gnu::always_inline]] inline void gather_gradients(const SweepData& data, Block block, const BlockWeights& weights,
                                                    BlockGradients& gradients) {
  const double inverse_x = 1 / data.grid.cell_x;
  const double inverse_y = 1 / data.grid.cell_y;
  const double* node_velocity = data.node_new_velocity;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  for (int p = 0; p < block.count; ++p) {
    const AxisWeights in_x{weights.s_x[p], weights.q_x[p], weights.r_x[p]};
    const Stencil velocity = stencil(node_velocity, weights.base[p], rows);
    const Pair along_x = sum_over_nodes(combined(velocity, shape_slopes(in_x)) * row_values(weights.s_y[p], weights.q_y[p]));
    const Pair along_y = sum_over_nodes(combined(velocity, shape_values(in_x)) * row_slopes(weights.r_y[p]));
    gradients.xx[p] = along_x.x * inverse_x;
    gradients.yx[p] = along_x.y * inverse_x;
    gradients.xy[p] = along_y.x * inverse_y;
    gradients.yy[p] = along_y.y * inverse_y;
  }
}

/// Sums for the nodes of one base while consecutive points share it; flushed to the nodes when the base changes. Right for
/// any order of points, fast when they are nearly sorted by cell.
template <class NodeRow, int lanes_a_node>
struct Accumulator {
  NodeRow column_0{};
  NodeRow column_1{};
  NodeRow column_2{};

  [[gnu::always_inline]] void add(const AxisValues& weights, NodeRow values) {
    column_0 = column_0 + weights.node[0] * values;
    column_1 = column_1 + weights.node[1] * values;
    column_2 = column_2 + weights.node[2] * values;
  }
  [[gnu::always_inline]] void flush(double* nodes, int base, std::size_t rows) {
    double* to = nodes + lanes_a_node * static_cast<std::size_t>(base);
    const std::size_t next = lanes_a_node * rows;
    (NodeRow::load(to) + column_0).store(to);
    (NodeRow::load(to + next) + column_1).store(to + next);
    (NodeRow::load(to + 2 * next) + column_2).store(to + 2 * next);
    *this = {};
  }
};
using PairAccumulator = Accumulator<Row, 2>;
using MassAccumulator = Accumulator<MassRow, 1>;

/// In-plane stresses of a block's points, as the nodes feel them.
struct BlockStress {
  const double *xx, *yy, *xy;
};

[[gnu::always_inline]] inline BlockStress stress_of(const SweepData& data, Block block) {
  return {data.xx + block.first, data.yy + block.first, data.xy + block.first};
}

/// What a point gives to the nodes.
enum class Give { momentum, force, both };

/// Mass and momentum m v, and internal force -V stress . grad N, to the nodes.
template <Give give>
[[gnu::always_inline]] inline void map_to_nodes(const SweepData& data, Block block, const BlockWeights& weights, BlockStress stress) {
  constexpr bool gives_momentum = give != Give::force;
  constexpr bool gives_force = give != Give::momentum;
  const double inverse_x = 1 / data.grid.cell_x;
  const double inverse_y = 1 / data.grid.cell_y;
  const double* velocity = data.velocity + 2 * block.first;
  const double* volume = data.volume + block.first;
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
    const AxisWeights in_x{weights.s_x[p], weights.q_x[p], weights.r_x[p]};
    const AxisValues values_x = shape_values(in_x);
    const Row values_y = row_values(weights.s_y[p], weights.q_y[p]);
    if constexpr (gives_momentum) {
      momentum_sums.add(values_x, values_y * pairs(mass[p] * velocity[2 * p], mass[p] * velocity[2 * p + 1]));
      mass_sums.add(values_x, mass[p] * mass_values(weights.s_y[p], weights.q_y[p]));
    }
    if constexpr (gives_force) {
      const double force_x = -volume[p] * inverse_x;
      const double force_y = -volume[p] * inverse_y;
      force_sums.add(shape_slopes(in_x), values_y * pairs(force_x * stress.xx[p], force_x * stress.xy[p]));
      force_sums.add(values_x, row_slopes(weights.r_y[p]) * pairs(force_y * stress.xy[p], force_y * stress.yy[p]));
    }
  }
  flush();
}

enum class SecondMap { yes, no };

/// v += sum N dv, drawn by grid_part towards sum N v; movement = dt sum N v; with the second map also sum N m v to the
/// nodes. Returns the energy that the drawing took.
template <SecondMap second_map>
[[gnu::always_inline]] inline double gather_block(const SweepData& data, Block block, const BlockWeights& weights) {
  double* velocity = data.velocity + 2 * block.first;
  double* movement = data.movement + 2 * block.first;
  const double* mass = data.mass + block.first;
  const double* node_velocity = data.node_velocity;
  const double* node_change = data.node_change;
  double* node_new_momentum = data.node_new_momentum;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  const double step = data.step;
  const double grid_part = data.grid_part;
  double damped = 0;
  PairAccumulator momentum_sums;
  int base = weights.base[0];
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      if constexpr (second_map == SecondMap::yes) momentum_sums.flush(node_new_momentum, base, rows);
      base = weights.base[p];
    }
    const AxisValues values_x = shape_values({weights.s_x[p], weights.q_x[p], weights.r_x[p]});
    const Row values_y = row_values(weights.s_y[p], weights.q_y[p]);
    const Pair change = sum_over_nodes(combined(stencil(node_change, base, rows), values_x) * values_y);
    const Pair moving = sum_over_nodes(combined(stencil(node_velocity, base, rows), values_x) * values_y);
    double velocity_x = velocity[2 * p] + change.x;
    double velocity_y = velocity[2 * p + 1] + change.y;
    if (grid_part > 0) {
      const double before = velocity_x * velocity_x + velocity_y * velocity_y;
      velocity_x += grid_part * (moving.x - velocity_x);
      velocity_y += grid_part * (moving.y - velocity_y);
      damped += 0.5 * mass[p] * (before - velocity_x * velocity_x - velocity_y * velocity_y);
    }
    velocity[2 * p] = velocity_x;
    velocity[2 * p + 1] = velocity_y;
    movement[2 * p] = step * moving.x;
    movement[2 * p + 1] = step * moving.y;
    if constexpr (second_map == SecondMap::yes) momentum_sums.add(values_x, values_y * pairs(mass[p] * velocity_x, mass[p] * velocity_y));
  }
  if constexpr (second_map == SecondMap::yes) momentum_sums.flush(node_new_momentum, base, rows);
  return damped;
}

}  // namespace
}  // namespace slidezone
