#include "scene/varied_soil.hpp"

#include <algorithm>
#include <cmath>

namespace slidezone {

double least_cohesion(const Layer& layer) { return layer.residual_cohesion_follows ? 0 : layer.material.residual_cohesion; }

double least_friction_angle(const Layer& layer) { return layer.residual_friction_follows ? 0 : layer.material.residual_friction_angle; }

/// Whether the residual cohesion of a soil is a field.
static bool has_residual_field(const Scene& scene, std::size_t soil) {
  return std::ranges::any_of(scene.fields, [&](const FieldSpec& spec) {
    return spec.parameter == Parameter::residual_cohesion && std::ranges::find(spec.soils, soil) != spec.soils.end();
  });
}

Limits limits_of(const FieldSpec& spec, const Scene& scene) {
  Limits limits;
  for (const std::size_t soil : spec.soils) {
    const Layer& layer = scene.layers[soil];
    const bool is_cohesion = spec.parameter == Parameter::cohesion && !has_residual_field(scene, soil);
    const bool is_friction = spec.parameter == Parameter::friction_angle;
    const double low = is_cohesion ? least_cohesion(layer) : is_friction ? least_friction_angle(layer) : 0;
    limits.low = std::isfinite(limits.low) ? std::min(limits.low, low) : low;
    if (is_friction) limits.high = largest_friction_angle;
  }
  return limits;
}

static std::optional<double>& at(ParameterValues& values, Parameter parameter) { return values[static_cast<std::size_t>(parameter)]; }

/// Moves a value that is there; returns 1 where it stands at a limit then.
static std::size_t hold(std::optional<double>& value, double low, double high) {
  if (!value) return 0;
  const bool is_at_limit = *value <= low || *value >= high;
  value = std::max(low, std::min(*value, high));
  return is_at_limit ? 1 : 0;
}

std::size_t hold_within_limits(ParameterValues& values, const Layer& layer) {
  std::optional<double>& cohesion = at(values, Parameter::cohesion);
  std::optional<double>& residual = at(values, Parameter::residual_cohesion);
  constexpr double none = std::numeric_limits<double>::infinity();
  std::size_t count = hold(at(values, Parameter::friction_angle), least_friction_angle(layer), largest_friction_angle);
  count += hold(cohesion, residual ? 0 : least_cohesion(layer), none);
  count += hold(residual, 0, cohesion.value_or(layer.material.peak_cohesion));
  return count;
}

Material varied_soil(const Layer& layer, const ParameterValues& values) {
  Material soil = layer.material;
  for (std::size_t parameter = 0; parameter < values.size(); ++parameter)
    if (values[parameter]) set(soil, static_cast<Parameter>(parameter), *values[parameter]);
  const bool has_residual = values[static_cast<std::size_t>(Parameter::residual_cohesion)].has_value();
  if (layer.residual_cohesion_follows && !has_residual) soil.residual_cohesion = soil.peak_cohesion;
  if (layer.residual_friction_follows) soil.residual_friction_angle = soil.peak_friction_angle;
  soil.dilation_angle = std::min(soil.dilation_angle, soil.peak_friction_angle);
  return soil;
}

}  // namespace slidezone
