// The parameters of one soil: linear elasticity, Drucker-Prager shear and tension yield, softening (Eqs. 8-22).
//
// Units: SI (Pa, rad, kg/m^3). Softening: beyond the threshold strain, cohesion and friction angle fall from peak to
// residual by exp(-shape * (plastic strain - threshold)); equal peak and residual means no softening.
#pragma once

#include <limits>

namespace slidezone {

struct Material {
  double density = 0;
  double youngs_modulus = 0;
  double poisson_ratio = 0;
  double peak_cohesion = 0;
  double residual_cohesion = 0;
  double peak_friction_angle = 0;
  double residual_friction_angle = 0;
  double dilation_angle = 0;
  double softening_threshold = 0;                                   // equivalent plastic strain at which softening begins
  double softening_shape = 0;                                       // eta
  double tension_cutoff = std::numeric_limits<double>::infinity();  // largest mean stress; the cone's apex bounds it too

  bool operator==(const Material&) const = default;
};

}  // namespace slidezone
