// The parameters of a soil that may vary from place to place, by the names of their keys in a scene.
#pragma once

#include <array>
#include <cstddef>

#include "soil/material.hpp"

namespace slidezone {

enum class Parameter { cohesion, residual_cohesion, friction_angle, youngs_modulus, unit_weight, density };

struct ParameterKind {
  const char* name;
  const char* unit;  // SI, as UDUNITS-2 spells it
};

inline constexpr std::array<ParameterKind, 6> parameter_kinds = {{{"cohesion", "Pa"},
                                                                  {"residual_cohesion", "Pa"},
                                                                  {"friction_angle", "rad"},
                                                                  {"youngs_modulus", "Pa"},
                                                                  {"unit_weight", "N m-3"},
                                                                  {"density", "kg m-3"}}};

inline const ParameterKind& kind_of(Parameter parameter) { return parameter_kinds[static_cast<std::size_t>(parameter)]; }

inline constexpr double standard_gravity = 9.81;  // m/s^2: turns a unit weight into a density, whatever [gravity] says

/// Cohesion and friction angle are those at the peak.
inline double value_of(const Material& soil, Parameter parameter) {
  switch (parameter) {
    case Parameter::cohesion:
      return soil.peak_cohesion;
    case Parameter::residual_cohesion:
      return soil.residual_cohesion;
    case Parameter::friction_angle:
      return soil.peak_friction_angle;
    case Parameter::youngs_modulus:
      return soil.youngs_modulus;
    case Parameter::unit_weight:
      return soil.density * standard_gravity;
    case Parameter::density:
      return soil.density;
  }
  return 0;
}

inline void set(Material& soil, Parameter parameter, double value) {
  switch (parameter) {
    case Parameter::cohesion:
      soil.peak_cohesion = value;
      break;
    case Parameter::residual_cohesion:
      soil.residual_cohesion = value;
      break;
    case Parameter::friction_angle:
      soil.peak_friction_angle = value;
      break;
    case Parameter::youngs_modulus:
      soil.youngs_modulus = value;
      break;
    case Parameter::unit_weight:
      soil.density = value / standard_gravity;
      break;
    case Parameter::density:
      soil.density = value;
      break;
  }
}

}  // namespace slidezone
