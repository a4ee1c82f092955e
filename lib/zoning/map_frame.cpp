#include "zoning/map_frame.hpp"

#include <cmath>

namespace slidezone {

/// Unit vector away from the slope.
static Vec2 outward(const MapFrame& frame, Side side) {
  const double sign = side == Side::toe ? 1 : -1;
  return {sign * std::sin(frame.bearing), sign * std::cos(frame.bearing)};
}

Vec2 place_at(const MapFrame& frame, Side side, double distance) {
  const Vec2 start = side == Side::toe ? frame.toe : frame.crest;
  const Vec2 along = outward(frame, side);
  return {start.x + distance * along.x, start.y + distance * along.y};
}

std::array<Vec2, 5> strip_between(const MapFrame& frame, Side side, double near, double far) {
  const Vec2 along = outward(frame, side);
  const Vec2 left{-along.y * frame.width / 2, along.x * frame.width / 2};
  const Vec2 a = place_at(frame, side, near);
  const Vec2 b = place_at(frame, side, far);
  const Vec2 first{a.x - left.x, a.y - left.y};
  return {first, Vec2{b.x - left.x, b.y - left.y}, Vec2{b.x + left.x, b.y + left.y}, Vec2{a.x + left.x, a.y + left.y}, first};
}

}  // namespace slidezone
