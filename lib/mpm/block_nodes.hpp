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
#pragma once

#include <cstddef>

#include "mpm/block_weights.hpp"
#include "mpm/lanes.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// f_ab as differences[a][b].
template <class Real, int n>
struct Differences {
  Lanes<Real, n> of[3][3];

  [[gnu::always_inline]] static void along(Lanes<Real, n>& a, Lanes<Real, n>& b, Lanes<Real, n>& c) {
    const Lanes<Real, n> first = b - a;
    c = (c - b) - first;
    b = first;
  }
  /// `numbers` of all nodes, `n` a node; `rows` nodes a column.
  [[gnu::always_inline]] void load(const Real* numbers, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    const Real* column = numbers + n * first_node;
    for (int a = 0; a < 3; ++a, column += n * rows) {
      for (int b = 0; b < 3; ++b) of[a][b] = Lanes<Real, n>::load(column + n * b);
      along(of[a][0], of[a][1], of[a][2]);
    }
    for (int b = 0; b < 3; ++b) along(of[0][b], of[1][b], of[2][b]);
  }
  /// sum N f
  [[gnu::always_inline]] Lanes<Real, n> value(Real s_x, Real q_x, Real s_y, Real q_y) const {
    Lanes<Real, n> along_y[3];
    for (int a = 0; a < 3; ++a) along_y[a] = fused(q_y, of[a][2], fused(s_y, of[a][1], of[a][0]));
    return fused(q_x, along_y[2], fused(s_x, along_y[1], along_y[0]));
  }
};

/// Sums of X_a Y_b g over points.
template <class Real, int n>
struct ValueSums {
  Lanes<Real, n> of[3][3]{};

  [[gnu::always_inline]] void add(Real s_x, Real q_x, Real s_y, Real q_y, Lanes<Real, n> gift) {
    const Lanes<Real, n> along_y[3] = {gift, s_y * gift, q_y * gift};
    for (int b = 0; b < 3; ++b) {
      of[0][b] = of[0][b] + along_y[b];
      of[1][b] = fused(s_x, along_y[b], of[1][b]);
      of[2][b] = fused(q_x, along_y[b], of[2][b]);
    }
  }
  [[gnu::always_inline]] static void to_nodes(Lanes<Real, n>& a, Lanes<Real, n>& b, Lanes<Real, n>& c) {
    const Lanes<Real, n> rest = b - c;
    a = a - rest;
    b = rest - c;
  }
  /// Adds to the numbers of the nodes, and begins anew.
  [[gnu::always_inline]] void give(Real* numbers, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    Real* column = numbers + n * first_node;
    for (int b = 0; b < 3; ++b) to_nodes(of[0][b], of[1][b], of[2][b]);
    for (int a = 0; a < 3; ++a, column += n * rows) {
      to_nodes(of[a][0], of[a][1], of[a][2]);
      for (int b = 0; b < 3; ++b) (Lanes<Real, n>::load(column + n * b) + of[a][b]).store(column + n * b);
    }
    *this = {};
  }
};

/// A point's weights for slopes of pairs: along y in the first two lanes, along x in the others.
template <class Real>
struct SlopeWeights {
  Four<Real> s, q, r;
};

template <class Real>
[[gnu::always_inline]] inline SlopeWeights<Real> slope_weights(const BlockWeights<Real>& weights, int p) {
  return {two_of_each(weights.s_x[p], weights.s_y[p]), two_of_each(weights.q_x[p], weights.q_y[p]),
          two_of_each(weights.r_y[p], weights.r_x[p])};
}

/// Slopes of pairs, f_k1 and f_k2 beside f_1k and f_2k.
template <class Real>
struct SlopeDifferences {
  Four<Real> first[3], second[3];

  [[gnu::always_inline]] void load(const Real* pairs, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    Differences<Real, 2> f;
    f.load(pairs, first_node, rows);
    for (int k = 0; k < 3; ++k) {
      first[k] = both(f.of[k][1], f.of[1][k]);
      second[k] = both(f.of[k][2], f.of[2][k]);
    }
  }
  /// h_y df/dy, then h_x df/dx
  [[gnu::always_inline]] Four<Real> value(const SlopeWeights<Real>& weights) const {
    Four<Real> slope[3];
    for (int k = 0; k < 3; ++k) slope[k] = fused(weights.r, second[k], first[k]);
    return fused(weights.q, slope[2], fused(weights.s, slope[1], slope[0]));
  }
};

/// Sums over points of gifts that go by slopes: of the first two lanes by h_y dN/dy, of the others by h_x dN/dx.
template <class Real>
struct SlopeSums {
  Four<Real> first[3]{}, second[3]{};

  [[gnu::always_inline]] void add(const SlopeWeights<Real>& weights, Four<Real> gift) {
    const Four<Real> across[3] = {gift, weights.s * gift, weights.q * gift};
    for (int k = 0; k < 3; ++k) {
      first[k] = first[k] + across[k];
      second[k] = fused(weights.r, across[k], second[k]);
    }
  }
  [[gnu::always_inline]] void give(Real* pairs, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    ValueSums<Real, 2> sums;
    sums.of[0][1] = low(first[0]);
    sums.of[1][0] = high(first[0]);
    sums.of[1][1] = low(first[1]) + high(first[1]);
    sums.of[2][1] = low(first[2]) + high(second[1]);
    sums.of[1][2] = high(first[2]) + low(second[1]);
    sums.of[0][2] = low(second[0]);
    sums.of[2][0] = high(second[0]);
    sums.of[2][2] = low(second[2]) + high(second[2]);
    sums.give(pairs, first_node, rows);
    *this = {};
  }
};

/// act(p) for all points of a block; load(first_node) before the first of those that share it.
template <class Load, class Act>
[[gnu::always_inline]] inline void gather_points(auto block, const int* first_node, Load load, Act act) {
  int now = first_node[0];
  load(now);
  for (int p = 0; p < block.count; ++p) {
    if (first_node[p] != now) {
      now = first_node[p];
      load(now);
    }
    act(p);
  }
}

/// act(p) for all points of a block; give(first_node) after the last of those that share it.
template <class Act, class Give>
[[gnu::always_inline]] inline void sum_points(auto block, const int* first_node, Act act, Give give) {
  int now = first_node[0];
  for (int p = 0; p < block.count; ++p) {
    if (first_node[p] != now) {
      give(now);
      now = first_node[p];
    }
    act(p);
  }
  give(now);
}

}  // namespace
}  // namespace slidezone
