// Blocks of points, and the shape functions of a block's points. Included by sweeps.cpp alone.
#pragma once

#include <cstddef>
#include <type_traits>

#include "grid/gimp.hpp"
#include "mpm/lanes.hpp"
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

/// Numbers of a block's points: pairs, or four each, point after point.
template <class Real>
using BlockPairs = Real[2 * block_size];
template <class Real>
using BlockFours = Real[4 * block_size];

/// Numbers of the next block, asked for while this one is computed with, some at a time: there are more arrays than a processor fetches
/// ahead by itself, and it waits when too many lines are on their way.
class Ahead {
 public:
  /// Of an array with `each` numbers a point, given where this block's are.
  template <class Number>
  [[gnu::always_inline]] void add(const Number* of_block, int each = 1) {
    const char* next = reinterpret_cast<const char*>(of_block + each * block_size);
    for (int k = 0; k < each * block_size * static_cast<int>(sizeof(Number)); k += part) parts_[count_++] = next + k;
  }
  [[gnu::always_inline]] void fetch_some() {
    if (fetched_ < count_) fetch_next_part();
  }
  [[gnu::always_inline]] void fetch_rest() {
    while (fetched_ < count_) fetch_next_part();
  }

 private:
  static constexpr int line = 64, part = 4 * line;  // bytes
  static constexpr int most_parts = 18;

  [[gnu::always_inline]] void fetch_next_part() {
    const char* begin = parts_[fetched_++];
    for (int k = 0; k < part; k += line) __builtin_prefetch(begin + k);
  }

  const char* parts_[most_parts];
  int count_ = 0;
  int fetched_ = 0;
};

/// Shape functions of a block's points, struct of arrays.
template <class Real>
struct BlockWeights {
  const Real *s_x, *s_y;  // where place() put them, as are the first nodes
  const int* first_node;
  Real q_x[block_size], r_x[block_size];
  Real q_y[block_size], r_y[block_size];
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

/// Where points lie along an axis now, as s of their first nodes.
template <class Real>
[[gnu::always_inline]] inline FirstNodes place_along(const double* position, auto block, Axis axis, Real* s) {
  if (block.count < 1) __builtin_unreachable();  // blocks are never empty
  FirstNodes first;
  const double half_size = axis.half_size;
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
    first.node[p] = node;
    s[p] = static_cast<Real>(in_cells - node);
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
  int out_of_order;
  bool is_lost;
};

/// Places a block's points anew: their first nodes and s.
template <class Real>
[[gnu::always_inline]] inline Reached place(const SweepData<Real>& data, auto block) {
  constexpr int reach = 3;  // nodes along each axis
  const FirstNodes in_x =
      place_along(data.x + block.first, block,
                  {1 / data.grid.cell_x, data.half_size_x, data.box.first_column, data.box.last_column - reach}, data.s_x + block.first);
  const FirstNodes in_y =
      place_along(data.y + block.first, block, {1 / data.grid.cell_y, data.half_size_y, data.box.first_row, data.box.last_row - reach},
                  data.s_y + block.first);
  int* first_node = data.first_node + block.first;
  for (int p = 0; p < block.count; ++p) first_node[p] = in_x.node[p] * data.storage.rows + in_y.node[p];
  int out_of_order = 0;
  for (int p = 1; p < block.count; ++p) out_of_order += first_node[p] < first_node[p - 1] ? 1 : 0;
  const NodeBox box = {in_x.low, in_x.high + reach, in_y.low, in_y.high + reach};
  for (int column = box.first_column; column < box.last_column; ++column)
    if (data.column_ends[column] < box.last_row) data.column_ends[column] = box.last_row;
  return {box, out_of_order, in_x.is_lost || in_y.is_lost};
}

template <class Real>
[[gnu::always_inline]] inline void weigh_along(const Real* s, auto block, double half_size, Real* q, Real* r) {
  const Real half = static_cast<Real>(half_size);
  const Real over_4l = static_cast<Real>(inverse_4l(half_size));
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const AxisWeightsOf<Real> weights = axis_weights(s[p], half, over_4l);
    q[p] = weights.q;
    r[p] = weights.r;
  }
}

/// Shape functions where a block's points were placed last.
template <class Real>
[[gnu::always_inline]] inline void weigh(const SweepData<Real>& data, auto block, BlockWeights<Real>& weights) {
  weights.s_x = data.s_x + block.first;
  weights.s_y = data.s_y + block.first;
  weights.first_node = data.first_node + block.first;
  weigh_along(weights.s_x, block, data.half_size_x, weights.q_x, weights.r_x);
  weigh_along(weights.s_y, block, data.half_size_y, weights.q_y, weights.r_y);
}

/// One number of all points after the other, from four numbers of each point, point after point.
template <class Real>
[[gnu::always_inline]] inline void separate(auto block, const BlockFours<Real>& of_points, Real* a, Real* b, Real* c, Real* d) {
  if constexpr (std::is_same_v<decltype(block), FullBlock> && !eight_fit<Real>) {
    for (int p = 0; p < block.count; p += 4) {
      Four<Real> numbers[4];
      for (int k = 0; k < 4; ++k) numbers[k] = Four<Real>::load(of_points + 4 * (p + k));
      transpose(numbers);
      numbers[0].store(a + p);
      numbers[1].store(b + p);
      numbers[2].store(c + p);
      numbers[3].store(d + p);
    }
  } else {  // what the compiler makes of this is better than transposes where eight numbers fit a register
#pragma GCC ivdep
    for (int p = 0; p < block.count; ++p) {
      a[p] = of_points[4 * p];
      b[p] = of_points[4 * p + 1];
      c[p] = of_points[4 * p + 2];
      d[p] = of_points[4 * p + 3];
    }
  }
}

}  // namespace
}  // namespace slidezone
