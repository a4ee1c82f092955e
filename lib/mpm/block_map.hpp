// From the points of a block to the nodes, by sums that stay in registers while points share their nodes. Included by sweeps.cpp
// alone.
#pragma once

#include "mpm/block_gather.hpp"
#include "mpm/block_rows.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// Sums for the nodes of one base while consecutive points share it, in the form of Stencil's differences; given to the nodes
/// when the base changes. Right for any order of points, fast when they are nearly sorted by base.
template <class Real, class NodeRow, int lanes_a_node>
struct Accumulator {
  NodeRow sum{};
  NodeRow sum_first{};
  NodeRow sum_second{};

  /// N_x values
  [[gnu::always_inline]] void add_values(Real s, Real q, NodeRow values) {
    sum = sum + values;
    sum_first = fused(s, values, sum_first);
    sum_second = fused(q, values, sum_second);
  }
  /// h dN_x/dx values
  [[gnu::always_inline]] void add_slopes(Real r, NodeRow values) {
    sum_first = sum_first + values;
    sum_second = fused(r, values, sum_second);
  }
  [[gnu::always_inline]] void flush(Real* nodes, int base, std::size_t rows) {
    Real* to = nodes + lanes_a_node * static_cast<std::size_t>(base);
    const std::size_t next = lanes_a_node * rows;
    const NodeRow rest = sum_first - sum_second;
    (NodeRow::load(to) + (sum - rest)).store(to);
    (NodeRow::load(to + next) + (rest - sum_second)).store(to + next);
    (NodeRow::load(to + 2 * next) + sum_second).store(to + 2 * next);
    *this = {};
  }
};
template <class Real>
using PairAccumulator = Accumulator<Real, Row<Real>, 2>;
template <class Real>
using MassAccumulator = Accumulator<Real, MassRow<Real>, 1>;

/// In-plane stresses of a block's points, as the nodes feel them.
template <class Real>
struct BlockStress {
  const Real *xx, *yy, *xy;
};

template <class Real>
[[gnu::always_inline]] inline BlockStress<Real> stress_of(const SweepData<Real>& data, auto block) {
  return {data.xx + block.first, data.yy + block.first, data.xy + block.first};
}

/// What a point gives to the nodes.
enum class Give { momentum, force, both };

/// What a block's points give to the nodes.
template <class Real>
struct BlockGifts {
  BlockPairs<Real> momentum;  // m v
  BlockPairs<Real> along_x;   // -V / h_x (s_xx, s_xy)
  BlockPairs<Real> along_y;   // -V / h_y (s_xy, s_yy)
};

template <Give give, class Real>
[[gnu::always_inline]] inline void prepare_gifts(const SweepData<Real>& data, auto block, BlockStress<Real> stress,
                                                 BlockGifts<Real>& gifts) {
  const Real* velocity = data.velocity + 2 * block.first;
  const Real* volume = data.volume + block.first;
  const Real* mass = data.mass + block.first;
  const Real inverse_x = static_cast<Real>(1 / data.grid.cell_x);
  const Real inverse_y = static_cast<Real>(1 / data.grid.cell_y);
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
      const Real force_x = -volume[p] * inverse_x;
      const Real force_y = -volume[p] * inverse_y;
      gifts.along_x[2 * p] = force_x * stress.xx[p];
      gifts.along_x[2 * p + 1] = force_x * stress.xy[p];
      gifts.along_y[2 * p] = force_y * stress.xy[p];
      gifts.along_y[2 * p + 1] = force_y * stress.yy[p];
    }
  }
}

/// Mass and momentum m v, and internal force -V stress . grad N, to the nodes.
template <Give give, class Real>
[[gnu::always_inline]] inline void map_to_nodes(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                BlockStress<Real> stress) {
  constexpr bool gives_momentum = give != Give::force;
  constexpr bool gives_force = give != Give::momentum;
  BlockGifts<Real> gifts;
  prepare_gifts<give>(data, block, stress, gifts);
  const Real* mass = data.mass + block.first;
  Real* node_momentum = data.node_momentum;
  Real* node_force = data.node_force;
  Real* node_mass = data.node_mass;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  PairAccumulator<Real> momentum_sums, force_sums;
  MassAccumulator<Real> mass_sums;
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
    const Real s_x = weights.s_x[p];
    const Real q_x = weights.q_x[p];
    const Row<Real> values_y = row_values(weights.s_y[p], weights.q_y[p]);
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

/// Momentum of moved points to the nodes, for the second time in a step.
template <class Real>
[[gnu::always_inline]] inline void map_momentum(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                const BlockPairs<Real>& momentum) {
  Real* node_new_momentum = data.node_new_momentum;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  PairAccumulator<Real> sums;
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

}  // namespace
}  // namespace slidezone
