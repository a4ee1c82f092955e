// Orders of material points: by the nodes that they reach, which makes sweeps fast and strips possible, and back to how they
// were numbered.
#pragma once

#include <span>
#include <vector>

#include "mpm/points.hpp"

namespace slidezone {

/// By first nodes, column by column; points of equal ones keep their order (counting sort).
std::vector<int> order_by_node(std::span<const int> first_nodes);

/// By label.
template <class Real>
std::vector<int> order_by_label(const PointsOf<Real>& points);

}  // namespace slidezone
