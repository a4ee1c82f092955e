// Orders of material points: by the nodes that they reach, which makes sweeps fast and strips possible, and back to how they
// were numbered.
#pragma once

#include <vector>

#include "grid/gimp.hpp"
#include "grid/node_storage.hpp"
#include "mpm/points.hpp"

namespace slidezone {

/// Column, or row, of the first node that a point at `place` reaches, of `count` in NodeStorage counting. `cell` in m, `half` the
/// half size of the point's domain in cells.
int first_node(double place, double cell, double half, int count);

/// By first nodes, column by column; points of equal ones keep their order (counting sort).
template <class Real>
std::vector<int> order_by_node(const PointsOf<Real>& points, const NodeStorage& storage, const GridShape& grid, HalfSize half);

/// By label.
template <class Real>
std::vector<int> order_by_label(const PointsOf<Real>& points);

}  // namespace slidezone
