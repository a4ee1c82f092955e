// Shape functions of the generalised interpolation material point method (GIMP; Bardenhagen and Kober 2004), with particle
// domains that keep their initial size (uGIMP).
//
// Along each axis a point at x, with a domain of half-size l cells, reaches three nodes i, i+1, i+2. With
//   u = x / h - l,   i = floor(u),   s = u - i + l,   o = max(0, s + l - 1),   q = o^2 / (4 l),   r = 2 o / (4 l):
//   N = {1 - s + q,  s - 2 q,  q},      h dN/dx = {r - 1,  1 - 2 r,  r}.
// s is the point's place in its first cell, o how far its domain reaches into the next one: without branches, and exact for
// 0 <= l <= 1/2. l = 0 gives linear shape functions. In two dimensions N = N_x N_y. sum N = 1 and sum dN = 0 everywhere.
// Nodes i = -1 and i = cells + 1 exist as padding (see node_storage.hpp), so the sums hold at the grid's edges too.
#pragma once

namespace slidezone {

/// Size of a point's domain, in cells, halved.
struct HalfSize {
  double x;
  double y;
};

/// The three numbers that give one axis' weights.
template <class Real>
struct AxisWeightsOf {
  Real s = 0;
  Real q = 0;
  Real r = 0;
};
using AxisWeights = AxisWeightsOf<double>;

/// Weights of a point at s of its first node. `inverse_4l` is 1 / (4 l), or 0 for linear shape functions.
template <class Real>
constexpr AxisWeightsOf<Real> axis_weights(Real s, Real half_size, Real inverse_4l) {
  const Real reach = s + (half_size - 1);
  const Real o = reach > 0 ? reach : 0;
  const Real half_r = o * inverse_4l;
  return {s, o * half_r, half_r + half_r};
}

/// The same for a point at `in_cells` = x / h whose first node is `first` = floor(in_cells - half_size). The place itself is a double: only
/// what is left of it within the cell may be rounded to less.
template <class Real>
constexpr AxisWeightsOf<Real> axis_weights(double in_cells, double first, Real half_size, Real inverse_4l) {
  return axis_weights(static_cast<Real>(in_cells - first), half_size, inverse_4l);
}

struct AxisValues {
  double node[3];
};

constexpr AxisValues shape_values(AxisWeights w) { return {{1 - w.s + w.q, w.s - 2 * w.q, w.q}}; }

/// h dN/dx.
constexpr AxisValues shape_slopes(AxisWeights w) { return {{w.r - 1, 1 - 2 * w.r, w.r}}; }

}  // namespace slidezone
