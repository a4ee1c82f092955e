// What a block's points get from the nodes that they reach, and give to them. Included by sweeps.cpp alone.
//
// A point reaches 3 x 3 nodes. With differences of their numbers f along an axis, f_0 = f(0), f_1 = f(1) - f(0) and
// f_2 = f(2) - 2 f(1) + f(0), the weights of grid/gimp.hpp give
//   sum N f = f_0 + s f_1 + q f_2,    sum h dN/dx f = f_1 + r f_2,
// and with differences along both, f_ab with a along x and b along y, X = (1, s_x, q_x) and Y = (1, s_y, q_y),
//   sum N f = sum_ab X_a Y_b f_ab,    h_x df/dx = sum_b Y_b (f_1b + r_x f_2b),    h_y df/dy = sum_a X_a (f_a1 + r_y f_a2).
// Points that share their first node share the differences, which stay in registers meanwhile. Points give to nodes by the transpose:
// first sums over points, for example of X_a Y_b g, then these to the nodes, with the signs that the nodes have in the differences.
// Right for any order of points, fast when they are nearly sorted by first node.
//
// Lanes of vectors carry what one node holds (by_node.hpp) or, where eight numbers fit a register, what three nodes of a column hold
// (by_column.hpp), which takes fewer instructions.
#pragma once

#include <cstddef>
#include <type_traits>

#include "mpm/block_weights.hpp"
#include "mpm/by_node.hpp"
#include "mpm/lanes.hpp"
#if SLIDEZONE_REGISTER_BYTES >= 32
#include "mpm/by_column.hpp"
#endif

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

#if SLIDEZONE_REGISTER_BYTES >= 32
template <class Real>
using Values = std::conditional_t<eight_fit<Real>, by_column::Values<Real>, by_node::Values<Real>>;
template <class Real>
using Slopes = std::conditional_t<eight_fit<Real>, by_column::Slopes<Real>, by_node::Slopes<Real>>;
template <class Real>
using PairSums = std::conditional_t<eight_fit<Real>, by_column::PairSums<Real>, by_node::PairSums<Real>>;
using by_column::MomentumAndForceSums;  // where eight numbers fit a register
using by_node::MomentumSums;
using by_node::SlopeSums;
#else
using namespace by_node;
template <class Real>
struct MomentumAndForceSums;  // named, but not used
#endif

/// act(p) for all points of a block, and before it change(now, next) wherever the first node is another than the last point's. Gives the
/// last one.
template <class Change, class Act>
[[gnu::always_inline]] inline int for_points(auto block, const int* first_node, Change change, Act act) {
  int now = first_node[0];
  for (int p = 0; p < block.count; ++p) {
    if (first_node[p] != now) {
      change(now, first_node[p]);
      now = first_node[p];
    }
    act(p);
  }
  return now;
}

struct DoNothing {
  [[gnu::always_inline]] void operator()() const {}
};

/// act(p, from_nodes) for all points of a block, where `from_nodes` holds the numbers of the nodes that point p reaches. Does a piece of
/// what is to be done meanwhile where the first node changes.
template <class FromNodes, class Real, class Act, class Meanwhile = DoNothing>
[[gnu::always_inline]] inline void gather_points(auto block, const int* first_node, const Real* numbers, std::ptrdiff_t rows, Act act,
                                                 Meanwhile meanwhile = {}) {
  FromNodes from_nodes;
  from_nodes.load(numbers, first_node[0], rows);
  for_points(
      block, first_node,
      [&](int, int next) __attribute__((always_inline)) {
        from_nodes.load(numbers, next, rows);
        meanwhile();
      },
      [&](int p) __attribute__((always_inline)) { act(p, from_nodes); });
}

/// add(p, sums) for all points of a block, whose sums go to numbers of the nodes; and what is to be done meanwhile.
template <class Sums, class Numbers, class Add, class Meanwhile = DoNothing>
[[gnu::always_inline]] inline void give_to_nodes(auto block, const int* first_node, Numbers numbers, std::ptrdiff_t rows, Add add,
                                                 Meanwhile meanwhile = {}) {
  Sums sums;
  const int last = for_points(
      block, first_node,
      [&](int now, int next) __attribute__((always_inline)) {
        sums.move_on(numbers, now, next, rows);
        meanwhile();
      },
      [&](int p) __attribute__((always_inline)) { add(p, sums); });
  sums.give(numbers, last, rows);
}

/// Both at once: act(p, from_nodes, sums) for all points of a block.
template <class FromNodes, class Sums, class Real, class Act>
[[gnu::always_inline]] inline void gather_and_give(auto block, const int* first_node, const Real* from, Real* to, std::ptrdiff_t rows,
                                                   Act act) {
  FromNodes from_nodes;
  from_nodes.load(from, first_node[0], rows);
  Sums sums;
  const auto change = [&](int now, int next) __attribute__((always_inline)) {
    sums.move_on(to, now, next, rows);
    from_nodes.load(from, next, rows);
  };
  const int last = for_points(
      block, first_node, change, [&](int p) __attribute__((always_inline)) { act(p, from_nodes, sums); });
  sums.give(to, last, rows);
}

}  // namespace
}  // namespace slidezone
