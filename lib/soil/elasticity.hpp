// Linear isotropic elasticity in plane strain, tension positive, Pa.
#pragma once

#include "soil/material.hpp"

namespace slidezone {

/// Components in the plane, and the normal stress across it. Tension positive.
template <class Real>
struct StressOf {
  Real xx = 0;
  Real yy = 0;
  Real zz = 0;
  Real xy = 0;
};
using Stress = StressOf<double>;

struct ElasticModuli {
  double bulk = 0;   // K = E / (3 (1 - 2 nu))
  double shear = 0;  // G = E / (2 (1 + nu))
};

constexpr ElasticModuli elastic_moduli(const Material& soil) {
  return {soil.youngs_modulus / (3 * (1 - 2 * soil.poisson_ratio)), soil.youngs_modulus / (2 * (1 + soil.poisson_ratio))};
}

/// Modulus of one-dimensional compression, M = K + 4/3 G: the stiffness that a plane wave meets.
constexpr double constrained_modulus(const Material& soil) {
  const ElasticModuli moduli = elastic_moduli(soil);
  return moduli.bulk + 4.0 / 3.0 * moduli.shear;
}

}  // namespace slidezone
