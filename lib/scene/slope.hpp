// The ground as polylines: what makes one a surface, where crest and toe lie.
//
// Lengths in metres; x to the right from the left wall, y up from the base.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/vec2.hpp"
#include "scene/scene.hpp"

namespace slidezone {

/// Two lengths are the same when they differ by less than this fraction: room for the rounding of "5 m" / "0.2 m".
inline constexpr double same_length = 1e-9;

/// What is wrong with a polyline, and at which of its vertices.
struct Flaw {
  std::size_t vertex;
  std::string message;
};

/// Flaws of any boundary between soils: negative elevations, repeated vertices, x that falls, vertical parts that fold back.
std::optional<Flaw> polyline_flaw(const std::vector<Vec2>& polyline);

/// Flaws of a ground surface: those above; a start away from the left wall; touching the base before the last vertex; no
/// fall right of the highest part; a crest at the left wall, from which no influence distance could be measured.
std::optional<Flaw> surface_flaw(const std::vector<Vec2>& surface);

/// Crest and toe of a surface without flaws.
Slope slope_of(std::vector<Vec2> surface);

/// Level ground behind a straight face: (0, height), (length - height / tan(angle), height), (length, 0).
/// 0 < angle <= pi/2, rad.
std::vector<Vec2> straight_slope(double height, double length, double angle);

}  // namespace slidezone
