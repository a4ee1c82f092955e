// Exchange between nodes and points with lanes that carry the numbers of one node (block_nodes.hpp), which need registers of two or four
// numbers. Nine nodes stay in registers. Included by block_nodes.hpp alone.
#pragma once

#include <cstddef>

#include "mpm/block_weights.hpp"
#include "mpm/lanes.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them
namespace by_node {

/// Differences f_ab of the numbers of nodes, `n` a node.
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
};

template <class Real>
struct Values : Differences<Real, 4> {
  /// sum N f
  [[gnu::always_inline]] Four<Real> value(const BlockWeights<Real>& weights, int p) const {
    Four<Real> along_y[3];
    for (int a = 0; a < 3; ++a) along_y[a] = fused(weights.q_y[p], this->of[a][2], fused(weights.s_y[p], this->of[a][1], this->of[a][0]));
    return fused(weights.q_x[p], along_y[2], fused(weights.s_x[p], along_y[1], along_y[0]));
  }
};

/// Sums of X_a Y_b g over points.
template <class Real, int n>
struct ValueSums {
  Lanes<Real, n> of[3][3]{};

  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, Lanes<Real, n> gift) {
    const Lanes<Real, n> along_y[3] = {gift, weights.s_y[p] * gift, weights.q_y[p] * gift};
    for (int b = 0; b < 3; ++b) {
      of[0][b] = of[0][b] + along_y[b];
      of[1][b] = fused(weights.s_x[p], along_y[b], of[1][b]);
      of[2][b] = fused(weights.q_x[p], along_y[b], of[2][b]);
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
  /// Before points with another first node. To go on with sums of nodes that both reach would take as long.
  [[gnu::always_inline]] void move_on(Real* numbers, std::ptrdiff_t first_node, std::ptrdiff_t, std::ptrdiff_t rows) {
    give(numbers, first_node, rows);
  }
};

/// Sums of momentum and mass.
template <class Real>
struct MomentumSums : ValueSums<Real, 4> {
  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, const Real* velocity, Real mass) {
    const Real one[2] = {1, 0};
    ValueSums<Real, 4>::add(weights, p, mass * both(Pair<Real>::load(velocity), Pair<Real>::load(one)));
  }
};

template <class Real>
using PairSums = ValueSums<Real, 2>;

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
struct Slopes {
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
  [[gnu::always_inline]] Four<Real> value(const BlockWeights<Real>& weights, int p) const {
    const SlopeWeights<Real> of_point = slope_weights(weights, p);
    Four<Real> slope[3];
    for (int k = 0; k < 3; ++k) slope[k] = fused(of_point.r, second[k], first[k]);
    return fused(of_point.q, slope[2], fused(of_point.s, slope[1], slope[0]));
  }
};

/// Sums over points of pairs that go by slopes, by_x by h_x dN/dx and by_y by h_y dN/dy. In lanes: those of by_y, then those of by_x.
template <class Real>
struct SlopeSums {
  Four<Real> first[3]{}, second[3]{};

  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, const Real* by_x, const Real* by_y) {
    const SlopeWeights<Real> of_point = slope_weights(weights, p);
    const Four<Real> gift = both(Pair<Real>::load(by_y), Pair<Real>::load(by_x));
    const Four<Real> across[3] = {gift, of_point.s * gift, of_point.q * gift};
    for (int k = 0; k < 3; ++k) {
      first[k] = first[k] + across[k];
      second[k] = fused(of_point.r, across[k], second[k]);
    }
  }
  [[gnu::always_inline]] void give(Real* pairs, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    PairSums<Real> sums;
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
  [[gnu::always_inline]] void move_on(Real* pairs, std::ptrdiff_t first_node, std::ptrdiff_t, std::ptrdiff_t rows) {
    give(pairs, first_node, rows);
  }
};

}  // namespace by_node
}  // namespace
}  // namespace slidezone
