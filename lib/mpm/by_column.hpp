// Exchange between nodes and points with lanes that carry the numbers of three nodes, one above the other (block_nodes.hpp), which need
// registers of eight numbers. Along x there are differences as in by_node.hpp; along y each lane has the weight of its node,
//   N_0 = 1 - s + q,  N_1 = s - 2 q,  N_2 = q,    h dN_0/dy = r - 1,  h dN_1/dy = 1 - 2 r,  h dN_2/dy = r.
// Nodes are given their sums as late as possible: where the next points begin one node above, as most do, two of three nodes of a column
// stay in registers. Giving to memory what was given to a moment ago, shifted by a node, would have to wait for it.
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
  [[gnu::always_inline]] Column without_lowest() const { return {without_first_pair(nodes)}; }

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
  [[gnu::always_inline]] static Column repeated(const Real* pair) { return {four_times(pair)}; }

  [[gnu::always_inline]] friend Column operator+(Column a, Column b) { return {a.nodes + b.nodes}; }
  [[gnu::always_inline]] friend Column operator-(Column a, Column b) { return {a.nodes - b.nodes}; }
  [[gnu::always_inline]] friend Column operator*(Column a, Column b) { return {a.nodes * b.nodes}; }
  [[gnu::always_inline]] friend Column operator*(Real a, Column b) { return {a * b.nodes}; }
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
  [[gnu::always_inline]] Four<Real> lowest() const { return first_four(two_nodes); }
  [[gnu::always_inline]] Column without_lowest() const { return {last_four_and(two_nodes, third), {}}; }

  [[gnu::always_inline]] static Column weights(const BlockWeights<Real>& weights, int p) {
    const Eight<Real> of_one = {{{1, 1, 1, 1, 0, 0, 0, 0}}};
    const Eight<Real> of_s = {{{-1, -1, -1, -1, 1, 1, 1, 1}}};
    const Eight<Real> of_q = {{{1, 1, 1, 1, -2, -2, -2, -2}}};
    const Eight<Real> q = eight_times(weights.q_y[p]);
    return {fused(q, of_q, fused(weights.s_y[p], of_s, of_one)), first_four(q)};
  }
  /// (mass v_x, mass v_y, mass, 0)
  [[gnu::always_inline]] static Column of_momentum(const Real* velocity, Real mass) {
    const Eight<Real> ones = {{{1, 0, 1, 0, 1, 0, 1, 0}}};
    const Eight<Real> momenta = mass * twice_with(velocity, ones);
    return {momenta, first_four(momenta)};
  }

  [[gnu::always_inline]] friend Column operator+(Column a, Column b) { return {a.two_nodes + b.two_nodes, a.third + b.third}; }
  [[gnu::always_inline]] friend Column operator-(Column a, Column b) { return {a.two_nodes - b.two_nodes, a.third - b.third}; }
  [[gnu::always_inline]] friend Column operator*(Column a, Column b) { return {a.two_nodes * b.two_nodes, a.third * b.third}; }
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

/// Sums over points of X_a g, for columns of nodes.
template <class Real, int n>
struct Sums {
  Column<Real, n> of[3]{};

  template <class Part>
  [[gnu::always_inline]] static void to_nodes(Part& a, Part& b, Part& c) {
    const Part rest = b - c;
    a = a - rest;
    b = rest - c;
  }
  template <class Part>
  [[gnu::always_inline]] static void add_to(Real* numbers, Part part) {
    (Part::load(numbers) + part).store(numbers);
  }
  /// Adds to the numbers of the nodes, and begins anew.
  [[gnu::always_inline]] void give(Real* numbers, std::ptrdiff_t first_node, std::ptrdiff_t rows) {
    to_nodes(of[0], of[1], of[2]);
    for (int a = 0; a < 3; ++a) add_to(numbers + n * (first_node + a * rows), of[a]);
    *this = {};
  }
  /// Gives as far as points with another first node do not go on.
  [[gnu::always_inline]] void move_on(Real* numbers, std::ptrdiff_t first_node, std::ptrdiff_t next, std::ptrdiff_t rows) {
    if (next != first_node + 1) return give(numbers, first_node, rows);
    Lanes<Real, n> lowest[3];
    for (int a = 0; a < 3; ++a) {
      lowest[a] = of[a].lowest();
      of[a] = of[a].without_lowest();
    }
    to_nodes(lowest[0], lowest[1], lowest[2]);
    for (int a = 0; a < 3; ++a) add_to(numbers + n * (first_node + a * rows), lowest[a]);
  }
};

/// Sums of N g.
template <class Real, int n>
struct ValueSums : Sums<Real, n> {
  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, Column<Real, n> gift) {
    gift = gift * Column<Real, n>::weights(weights, p);
    this->of[0] = this->of[0] + gift;
    this->of[1] = fused(weights.s_x[p], gift, this->of[1]);
    this->of[2] = fused(weights.q_x[p], gift, this->of[2]);
  }
};

/// Sums of momentum and mass.
template <class Real>
struct MomentumSums : ValueSums<Real, 4> {
  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, const Real* velocity, Real mass) {
    ValueSums<Real, 4>::add(weights, p, Column<Real, 4>::of_momentum(velocity, mass));
  }
};

/// Sums of pairs.
template <class Real>
struct PairSums : ValueSums<Real, 2> {
  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, const Real* pair) {
    ValueSums<Real, 2>::add(weights, p, Column<Real, 2>::repeated(pair));
  }
};

/// Sums of pairs that go by slopes: by_x by h_x dN/dx, by_y by h_y dN/dy.
template <class Real>
struct SlopeSums : Sums<Real, 2> {
  [[gnu::always_inline]] void add(const BlockWeights<Real>& weights, int p, const Real* by_x, const Real* by_y) {
    const Column<Real, 2> along_x = Column<Real, 2>::repeated(by_x) * Column<Real, 2>::weights(weights, p);
    const Column<Real, 2> along_y = Column<Real, 2>::repeated(by_y) * Column<Real, 2>::slopes(weights, p);
    this->of[0] = this->of[0] + along_y;
    this->of[1] = this->of[1] + fused(weights.s_x[p], along_y, along_x);  // one chain of sums would be twice as long
    this->of[2] = this->of[2] + fused(weights.r_x[p], along_x, weights.q_x[p] * along_y);
  }
};

}  // namespace by_column
}  // namespace
}  // namespace slidezone
