// Two-body contact of soil on a rigid base, after Bardenhagen, Brackbill and Sulsky (2000).
//
// The base is a rigid body below y = 0, filled like the soil and of its density. At a node that both bodies reach, the normal
// is that of the difference of the two mass gradients, n = (G_soil - G_base) / |...| with G = sum m grad N; it points out of
// the soil. Soil that approaches along n loses that part of its velocity, and friction is at most mu times it; soil that
// recedes is free. Once per step: the second velocities of MUSL are left alone.
// Against a bilateral base (settings.hpp) this lets the front of a slide ride over the base, where the gradients lean.
#pragma once

#include <span>
#include <vector>

#include "grid/gimp.hpp"
#include "grid/node_storage.hpp"
#include "mpm/nodes.hpp"
#include "mpm/points.hpp"

namespace slidezone {

/// Normals at the nodes of the base, from the points in their present positions.
template <class Real>
ContactNormals contact_normals(const PointsOf<Real>& points, const GridShape& grid, HalfSize half_size, double base_density);

}  // namespace slidezone
