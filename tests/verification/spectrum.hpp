// The longest stable step of an elastic body in theory: from the spectrum of its step, while its points hardly move.
//
// Let K be the stiffness of the nodes that the points sum up (sum V B^T D B), M their lumped mass (sum m N) and Mc the consistent
// one (sum m N N^T). FLIP gives points the change of the nodes' velocities; seen from the nodes, of a change a dt they find
// S a dt again in the next step, S = M^-1 Mc with eigenvalues in [0, 1]. With d the movement that stress remembers, A = M^-1 K:
//   MUSL, USF   d'' - 2 d' + d = -dt^2 S A d'                   stable while  dt^2 max(S A) <= 4
//   USL         d'' - 2 d' + d = -dt^2 (A d' - (1 - S) A d)     stable while  dt^2 max((2 - S) A) <= 4
// (max: greatest eigenvalue.) S = 1 is the central difference of finite elements with lumped mass. MUSL and USF differ in where
// points are when the strain is taken, which is the same for points that do not move. USL: along an eigenvector of growth z,
// multiplied by (A d)^T M, the step is (z - 1)^2 + t (z - 1 + s) = 0 with 0 <= s <= 1 and t > 0; as dt grows, the first
// root to leave the unit circle does so at z = -1.
//
// Own derivation. For bodies that touch no wall and no base.
#pragma once

#include "mpm/simulation.hpp"

namespace slidezone {

/// s.
double longest_stable_step(const Model& model);

}  // namespace slidezone
