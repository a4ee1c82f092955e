// Exchange between nodes and points with lanes that carry the numbers of three nodes, one above the other (block_nodes.hpp), which need
// registers of eight numbers. Along x there are differences as in by_node.hpp; along y each lane has the weight of its node,
//   N_0 = 1 - s + q,  N_1 = s - 2 q,  N_2 = q,    h dN_0/dy = r - 1,  h dN_1/dy = 1 - 2 r,  h dN_2/dy = r.
// Nodes are given their sums as late as possible: where the next points begin one node above, as most do, two of three nodes of a column
// stay in registers. Giving to memory what was given to a moment ago, shifted by a node, would have to wait for it. Pairs of three nodes
// leave two of eight lanes over, in which masses go along.
// Included by block_nodes.hpp alone.
#pragma once

#include <cstddef>

#include "mpm/block_weights.hpp"
#include "mpm/lanes.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them
namespace by_column {

/// Numbers of the nodes of a column, `n` a node.
template <class Real, int n>
struct Column;

/// Two a node; the last two lanes belong to the node above the three and have the weight 0.
template <class Real>
struct Column<Real, 2> {
  Eight<Real> nodes{};

  [[gnu::always_inline]] static Column load(const Real* numbers) { return {Eight<Real>::load(numbers)}; }
  [[gnu::always_inline]] void store(Real* numbers) const { nodes.store(numbers); }
  [[gnu::always_inline]] Pair<Real> lowest() const { return low(first_four(nodes)); }
  [[gnu::always_inline]] Column without_lowest() const { return {chosen<2, 3, 4, 5, 6, 7, 8, 8>(nodes, {})}; }

  [[gnu::always_inline]] static Column weights(const BlockWeights<Real>& weights, int p) {
    const Column of_one = {{{1, 1, 0, 0, 0, 0, 0, 0}}};
    const Column of_s = {{{-1, -1, 1, 1, 0, 0, 0, 0}}};
    const Column of_q = {{{1, 1, -2, -2, 1, 1, 0, 0}}};
    return fused(weights.q_y[p], of_q, fused(weights.s_y[p], of_s, of_one));
  }
  [[gnu::always_inline]] static Column slopes(const BlockWeights<Real>& weights, int p) {
    const Column of_one = {{{-1, -1, 1, 1, 0, 0, 0, 0}}};
    const Column of_r = {{{1, 1, -2, -2, 1, 1, 0, 0}}};
    return fused(weights.r_y[p], of_r, of_one);
  }

  [[gnu::always_inline]] friend Column operator+(Column a, Column b) { return {a.nodes + b.nodes}; }
  [[gnu::always_inline]] friend Column operator-(Column a, Column b) { return {a.nodes - b.nodes}; }
  [[gnu::always_inline]] friend Column operator*(Column a, Column b) { return {a.nodes * b.nodes}; }
  [[gnu::always_inline]] friend Column fused(Real a, Column b, Column c) { return {fused(a, b.nodes, c.nodes)}; }
};

/// Four a node.
template <class Real>
struct Column<Real, 4> {
  Eight<Real> two_nodes{};
  Four<Real> third{};

  [[gnu::always_inline]] static Column load(const Real* numbers) { return {Eight<Real>::load(numbers), Four<Real>::load(numbers + 8)}; }
  [[gnu::always_inline]] void store(Real* numbers) const {
    two_nodes.store(numbers);
    third.store(numbers + 8);
  }
  [[gnu::always_inline]] static Column weights(const BlockWeights<Real>& weights, int p) {
    const Eight<Real> of_one = {{{1, 1, 1, 1, 0, 0, 0, 0}}};
    const Eight<Real> of_s = {{{-1, -1, -1, -1, 1, 1, 1, 1}}};
    const Eight<Real> of_q = {{{1, 1, 1, 1, -2, -2, -2, -2}}};
    const Eight<Real> q = eight_times(weights.q_y[p]);
    return {fused(q, of_q, fused(weights.s_y[p], of_s, of_one)), first_four(q)};
  }
  [[gnu::always_inline]] friend Column operator+(Column a, Column b) { return {a.two_nodes + b.two_nodes, a.third + b.third}; }
  [[gnu::always_inline]] friend Column operator-(Column a, Column b) { return {a.two_nodes - b.two_nodes, a.third - b.third}; }
  [[gnu::always_inline]] friend Column fused(Real a, Column b, Column c) {
    const Eight<Real> everywhere = eight_times(a);
    return {fused(everywhere, b.two_nodes, c.two_nodes), fused(first_four(everywhere), b.third, c.third)};
  }
};

/// Differences along x of three columns.
template <class Real, int n>
struct Differences {
  Column<Real, n> of[3];

  /// `numbers` of all nodes, `n` a node; `rows` nodes a column.
  [[gnu::always_inline]] void load(const Real* numbers, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    const Column<Real, n> a = Column<Real, n>::load(numbers + n * first_node);
    const Column<Real, n> b = Column<Real, n>::load(numbers + n * (first_node + rows));
    const Column<Real, n> c = Column<Real, n>::load(numbers + n * (first_node + 2 * rows));
    of[0] = a;
    of[1] = b - a;
    of[2] = (c - b) - (b - a);
  }
  [[gnu::always_inline]] Column<Real, n> along_x(const BlockWeights<Real>& weights, int p) const {
    return fused(weights.q_x[p], of[2], fused(weights.s_x[p], of[1], of[0]));
  }
};

template <class Real>
struct Values : Differences<Real, 4> {
  /// sum N f
  [[gnu::always_inline]] Four<Real> value(const BlockWeights<Real>& weights, int p) const {
    const Column<Real, 4> here = Column<Real, 4>::weights(weights, p);
    const Column<Real, 4> numbers = this->along_x(weights, p);
    const Eight<Real> of_two = here.two_nodes * numbers.two_nodes;
    return fused(here.third, numbers.third, first_four(of_two)) + last_four(of_two);
  }
};

template <class Real>
struct Slopes : Differences<Real, 2> {
  /// h_y df/dy, then h_x df/dx
  [[gnu::always_inline]] Four<Real> value(const BlockWeights<Real>& weights, int p) const {
    const Column<Real, 2> slope_x = fused(weights.r_x[p], this->of[2], this->of[1]);
    return sums_of_pairs((Column<Real, 2>::slopes(weights, p) * this->along_x(weights, p)).nodes,
                         (Column<Real, 2>::weights(weights, p) * slope_x).nodes);
  }
};

/// Sums of X_a g, for the nodes of three columns.
template <class Part>
[[gnu::always_inline]] inline void to_nodes(Part (&sums)[3]) {
  const Part rest = sums[1] - sums[2];
  sums[0] = sums[0] - rest;
  sums[1] = rest - sums[2];
}

/// Adds sums of X_a g to the numbers of nodes, `n` a node: those that a Part holds, in each of three columns.
template <int n, class Part, class Real>
[[gnu::always_inline]] inline void add_to_nodes(Part (&sums)[3], Real* numbers, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
  to_nodes(sums);
  for (int a = 0; a < 3; ++a) {
    Real* of_column = numbers + n * (first_node + a * rows);
    (Part::load(of_column) + sums[a]).store(of_column);
  }
}

/// Sums of pairs: X_a N g, for columns of nodes.
template <class Real>
struct PairSums {
  Column<Real, 2> of[3]{};

  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, Pair<Real> pair) {
    const Column<Real, 2> gift = Column<Real, 2>{four_times(pair)} * Column<Real, 2>::weights(weights, p);
    of[0] = of[0] + gift;
    of[1] = fused(weights.s_x[p], gift, of[1]);
    of[2] = fused(weights.q_x[p], gift, of[2]);
  }
  /// Adds to the pairs of the nodes, and begins anew.
  [[gnu::always_inline]] void give(Real* pairs, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    add_to_nodes<2>(of, pairs, first_node, rows);
    *this = {};
  }
  /// Gives as far as points with another first node do not go on.
  [[gnu::always_inline]] void move_on(Real* pairs, std::ptrdiff_t first_node, std::ptrdiff_t next, std::ptrdiff_t rows) {
    if (next != first_node + 1) return give(pairs, first_node, rows);
    Pair<Real> lowest[3];
    for (int a = 0; a < 3; ++a) {
      lowest[a] = of[a].lowest();
      of[a] = of[a].without_lowest();
    }
    add_to_nodes<2>(lowest, pairs, first_node, rows);
  }
};

/// Sums of momentum and mass, four a node, and of pairs that go by slopes: by_x by h_x dN/dx, by_y by h_y dN/dy.
template <class Real>
struct MomentumAndForceSums {
  struct Target {
    Real* momentum;
    Real* force;
  };
  // With lanes 6 and 7, which pairs of three nodes leave over, for the masses.
  Eight<Real> momentum[3]{};  // X_a N m v, then X_a N m of the lower two nodes
  Eight<Real> by_y[3]{};      // X_a h_y dN/dy by_y, then X_a N m of the third node, and 0
  Eight<Real> by_x[2]{};      // of dX_1 and dX_2, that is 1 and r_x: N by_x, then nothing of use

  /// `mass_of_third`: mass times the weight of the third node along y.
  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, const Real* velocity, Real mass, Real mass_of_third,
                                  const Real* force_by_x, const Real* force_by_y) {
    const Eight<Real> of_one = {{{1, 1, 0, 0, 0, 0, 1, 0}}};
    const Eight<Real> of_s = {{{-1, -1, 1, 1, 0, 0, -1, 1}}};
    const Eight<Real> of_q = {{{1, 1, -2, -2, 1, 1, 1, -2}}};
    const Eight<Real> ones = {{{1, 1, 1, 1, 1, 1, 1, 1}}};
    const Eight<Real> here = fused(weights.q_y[p], of_q, fused(weights.s_y[p], of_s, of_one));
    const Eight<Real> gift = (mass * with_three_times(ones, velocity)) * here;
    momentum[0] = momentum[0] + gift;
    momentum[1] = fused(weights.s_x[p], gift, momentum[1]);
    momentum[2] = fused(weights.q_x[p], gift, momentum[2]);
    const Eight<Real> along_x = four_times(force_by_x) * here;
    const Eight<Real> along_y = with_seventh(four_times(force_by_y) * Column<Real, 2>::slopes(weights, p).nodes, mass_of_third);
    by_x[0] = by_x[0] + along_x;
    by_x[1] = fused(weights.r_x[p], along_x, by_x[1]);
    by_y[0] = by_y[0] + along_y;
    by_y[1] = fused(weights.s_x[p], along_y, by_y[1]);
    by_y[2] = fused(weights.q_x[p], along_y, by_y[2]);
  }
  [[gnu::always_inline]] void give(Target nodes, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    Column<Real, 4> with_mass[3];
    for (int a = 0; a < 3; ++a)
      with_mass[a] = {chosen<0, 1, 6, 15, 2, 3, 7, 15>(momentum[a], by_y[a]), chosen<4, 5, 14, 15>(momentum[a], by_y[a])};
    add_to_nodes<4>(with_mass, nodes.momentum, first_node, rows);
    Eight<Real> force[3] = {by_y[0], by_y[1] + by_x[0], by_y[2] + by_x[1]};
    for (Eight<Real>& of_column : force) of_column = chosen<0, 1, 2, 3, 4, 5, 8, 8>(of_column, Eight<Real>{});
    add_to_nodes<2>(force, nodes.force, first_node, rows);
    *this = {};
  }
  [[gnu::always_inline]] void move_on(Target nodes, std::ptrdiff_t first_node, std::ptrdiff_t next, std::ptrdiff_t rows) {
    if (next != first_node + 1) return give(nodes, first_node, rows);
    Four<Real> with_mass[3];
    Pair<Real> force[3];
    for (int a = 0; a < 3; ++a) {
      with_mass[a] = chosen<0, 1, 6, 15>(momentum[a], by_y[a]);
      momentum[a] = chosen<2, 3, 4, 5, 15, 15, 7, 14>(momentum[a], by_y[a]);
      if (a > 0) by_y[a] = by_y[a] + by_x[a - 1];
      force[a] = low(first_four(by_y[a]));
      by_y[a] = chosen<2, 3, 4, 5, 8, 8, 8, 8>(by_y[a], Eight<Real>{});
    }
    by_x[0] = by_x[1] = {};
    add_to_nodes<4>(with_mass, nodes.momentum, first_node, rows);
    add_to_nodes<2>(force, nodes.force, first_node, rows);
  }
};

}  // namespace by_column
}  // namespace
}  // namespace slidezone
