// How long a step each method allows: as a part of smallest cell / speed of plane waves, wherever points lie.
//
// l is half the size of a point's domain in cells: 1 / (2 n) for n points along a cell, 0 for linear shape functions.
//   MUSL, USF   min(1, 0.5 + 2 l): below the shortest edge of stability that a search over the places of up to 10 points finds
//               (tests/verification/worst_edge.cpp), for any Poisson's ratio. Soil as it is deposited allows 1.1 and more.
//   USL         sqrt(2 (1 - nu) l (1 - l) / (2 - l)): a point on its own at the rim, where a node feels its stiffness by
//               |dN|^2 and its mass by N only. With w^2 the greatest eigenvalue of stiffness over lumped mass USL is stable
//               where dt w <= sqrt(2), and w^2 is at most c^2 / (h^2 (1 - nu)) sum |h dN|^2 / N, a sum of at most 2 / l + 1 / (1 - l).
//               It vanishes with l: with linear shape functions no step is stable.
// Own derivation, see tests/verification/spectrum.hpp. MUSL and USF are spared most of it, for there a node that weighs little
// hardly moves a point and so is hardly heard of again. Averages over cells (B-bar) only soften.
#pragma once

#include "mpm/settings.hpp"

namespace slidezone {

double stable_part(const Scheme& method, double half_size, double poisson_ratio);

}  // namespace slidezone
