// Blocks of points, and the shape functions of a block's points. Included by sweeps.cpp alone.
#pragma once

#include <cstddef>

#include "grid/gimp.hpp"
#include "mpm/sweeps.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

constexpr int block_size = 64;  // points a block: its arrays stay in the first-level cache

/// Points first, first + 1, ... of one block. The count of a full one is known to the compiler, whose vector loops then need
/// no remainder; the functions on blocks take either.
struct FullBlock {
  std::size_t first;
  static constexpr int count = block_size;
};
struct LastBlock {
  std::size_t first;
  int count;
};

/// Shape functions of a block's points, struct of arrays.
template <class Real>
struct BlockWeights {
  Real s_x[block_size], q_x[block_size], r_x[block_size];
  Real s_y[block_size], q_y[block_size], r_y[block_size];
  int base[block_size];  // index of the first node that the point reaches
};

double inverse_4l(double half_size) { return half_size > 0 ? 1 / (4 * half_size) : 0; }

/// One axis along which a block's points lie.
struct Axis {
  double inverse_cell;
  double half_size;  // of a point's domain, in cells
  int low, high;     // first nodes that the box allows, in NodeStorage counting
};

/// First nodes of a block's points along one axis.
struct FirstNodes {
  int node[block_size];
  int low, high;  // the least and the greatest of them
  bool is_lost;   // some point reaches beyond the box, or is not finite; its first node is kept within the box all the same
};

template <class Real>
[[gnu::always_inline]] inline FirstNodes weigh_axis(const double* position, auto block, Axis axis, Real* s, Real* q, Real* r) {
  if (block.count < 1) __builtin_unreachable();  // blocks are never empty
  FirstNodes first;
  const double half_size = axis.half_size;
  const Real half = static_cast<Real>(half_size);
  const Real over_4l = static_cast<Real>(inverse_4l(half_size));
  const double low = axis.low;
  const double high = axis.high;
  const double above = high + 1;
  long lost = 0;  // as wide as a double, so that both fill the same vector
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const double in_cells = position[p] * axis.inverse_cell + NodeStorage::padding;
    const double place = in_cells - half_size;
    const double at_least = place > low ? place : low;
    const int node = static_cast<int>(at_least < high ? at_least : high);
    const AxisWeightsOf<Real> weights = axis_weights(in_cells, node, half, over_4l);
    first.node[p] = node;
    s[p] = weights.s;
    q[p] = weights.q;
    r[p] = weights.r;
    lost |= (place >= low) & (place < above) ? 0L : 1L;
  }
  first.low = axis.high;
  first.high = axis.low;
  for (int p = 0; p < block.count; ++p) {
    first.low = first.node[p] < first.low ? first.node[p] : first.low;
    first.high = first.node[p] > first.high ? first.node[p] : first.high;
  }
  first.is_lost = lost != 0;
  return first;
}

/// The nodes that a block's points reach, beside their weights.
struct Reached {
  NodeBox box;
  bool is_lost;
};

template <class Real>
[[gnu::always_inline]] inline Reached weigh(const SweepData<Real>& data, auto block, BlockWeights<Real>& weights) {
  constexpr int reach = 3;  // nodes along each axis
  const FirstNodes in_x =
      weigh_axis(data.x + block.first, block, {1 / data.grid.cell_x, data.half_size_x, data.box.first_column, data.box.last_column - reach},
                 weights.s_x, weights.q_x, weights.r_x);
  const FirstNodes in_y =
      weigh_axis(data.y + block.first, block, {1 / data.grid.cell_y, data.half_size_y, data.box.first_row, data.box.last_row - reach},
                 weights.s_y, weights.q_y, weights.r_y);
  for (int p = 0; p < block.count; ++p) weights.base[p] = in_x.node[p] * data.storage.rows + in_y.node[p];
  return {{in_x.low, in_x.high + reach, in_y.low, in_y.high + reach}, in_x.is_lost || in_y.is_lost};
}

}  // namespace
}  // namespace slidezone
