// The soil at a place where parameters vary: what fields say there, within the limits that keep it a soil.
//
//   friction angle     from the soil's residual one, or 0 where that follows the peak, to 89 degrees
//   cohesion           from the soil's residual one, or 0 where that follows the peak or is a field itself
//   residual cohesion  from 0 to the peak: of two fields the peak's holds
//
// A residual strength that the scene does not give is the peak's, wherever that varies: the soil stays perfectly plastic. The
// dilation angle is at most the friction angle of the place. Values beyond a limit are moved to it and counted. All other parameters
// are positive, which rfgen sees to.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>

#include "field/random_fields.hpp"
#include "scene/scene.hpp"
#include "soil/parameter.hpp"

namespace slidezone {

/// By parameter; nothing where the soil's own value holds.
using ParameterValues = std::array<std::optional<double>, parameter_kinds.size()>;

inline constexpr double largest_friction_angle = 89 * std::numbers::pi / 180;  // rad

/// Lowest strengths of a soil whose peak varies.
double least_cohesion(const Layer& layer);
double least_friction_angle(const Layer& layer);

/// What the values of a whole field are held to: the widest limits of the soils that have it. Those of each place are narrower.
Limits limits_of(const FieldSpec& spec, const Scene& scene);

/// Moves values to the limits that they lie beyond; returns how many stand at one.
std::size_t hold_within_limits(ParameterValues& values, const Layer& layer);

/// The soil with values that are within their limits.
Material varied_soil(const Layer& layer, const ParameterValues& values);

}  // namespace slidezone
