// The section laid on the map: from distances before the toe and behind the crest to eastings and northings.
//
// Map coordinates in m, x east, y north; the slope faces along `bearing` (rad, clockwise from north). Distances run away from the slope:
// from the toe along the bearing, from the crest against it. Zones are drawn as strips of `width` along the slope, as the plane-strain
// section knows no end of the slide in that direction.
#pragma once

#include <array>

#include "core/vec2.hpp"

namespace slidezone {

struct MapFrame {
  Vec2 crest;
  Vec2 toe;
  double bearing = 0;
  double width = 0;
};

enum class Side { toe, crest };

/// The place on the section's axis.
Vec2 place_at(const MapFrame& frame, Side side, double distance);

/// The corners of the strip between two distances, counter-clockwise, the first again at the end.
std::array<Vec2, 5> strip_between(const MapFrame& frame, Side side, double near, double far);

}  // namespace slidezone
