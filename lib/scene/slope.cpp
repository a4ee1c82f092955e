#include "scene/slope.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/text.hpp"

namespace slidezone {

static bool is_lower(Vec2 a, Vec2 b) { return a.y < b.y; }

static std::string point_text(Vec2 point) { return "(" + format_brief(point.x, 6) + " m, " + format_brief(point.y, 6) + " m)"; }

/// Whether the polyline turns back on itself at the vertex: up and down again, or down and up, at one x.
static bool folds_back(const std::vector<Vec2>& polyline, std::size_t vertex) {
  if (vertex == 0 || vertex + 1 == polyline.size()) return false;
  const Vec2 before = polyline[vertex - 1], here = polyline[vertex], after = polyline[vertex + 1];
  return before.x == here.x && here.x == after.x && (here.y - before.y) * (after.y - here.y) < 0;
}

std::optional<Flaw> polyline_flaw(const std::vector<Vec2>& polyline) {
  for (std::size_t i = 0; i < polyline.size(); ++i) {
    const Vec2 here = polyline[i];
    if (here.y < 0) return Flaw{i, "wants elevations of at least 0 m, found " + point_text(here)};
    if (folds_back(polyline, i)) return Flaw{i, "folds back on itself at " + point_text(here)};
    if (i == 0) continue;
    const Vec2 before = polyline[i - 1];
    if (here.x < before.x)
      return Flaw{i, "wants points from left to right, found " + point_text(here) + " after " + point_text(before) +
                         "; an overhang cannot be described"};
    if (here.x == before.x && here.y == before.y) return Flaw{i, "has the point " + point_text(here) + " twice"};
  }
  return std::nullopt;
}

/// The last vertex of greatest elevation.
static std::size_t crest_of(const std::vector<Vec2>& surface) {
  std::size_t crest = 0;
  for (std::size_t i = 1; i < surface.size(); ++i)
    if (surface[i].y >= surface[crest].y) crest = i;
  return crest;
}

std::optional<Flaw> surface_flaw(const std::vector<Vec2>& surface) {
  if (const auto flaw = polyline_flaw(surface)) return flaw;
  if (surface.front().x != 0) return Flaw{0, "wants its first point at the left wall, x = 0 m, found " + point_text(surface.front())};
  for (std::size_t i = 0; i + 1 < surface.size(); ++i)
    if (surface[i].y == 0) return Flaw{i, "touches the base at " + point_text(surface[i]) + "; only its last point may"};
  const std::size_t crest = crest_of(surface);
  if (crest + 1 == surface.size()) return Flaw{crest, "never falls right of its highest point " + point_text(surface[crest])};
  if (surface[crest].x == 0) return Flaw{crest, "has its crest at the left wall; put some ground behind the crest"};
  return std::nullopt;
}

Slope slope_of(std::vector<Vec2> surface) {
  const auto crest = surface.begin() + static_cast<std::ptrdiff_t>(crest_of(surface));
  const Vec2 toe = *std::min_element(crest + 1, surface.end(), is_lower);
  const Vec2 crest_point = *crest;
  return {std::move(surface), crest_point, toe};
}

std::vector<Vec2> straight_slope(double height, double length, double angle) {
  const double face = angle == std::numbers::pi / 2 ? 0 : height / std::tan(angle);
  return {{0, height}, {length - face, height}, {length, 0}};
}

double elevation(const std::vector<Vec2>& polyline, double x) {
  const auto lies_left = [](Vec2 point, double at) { return point.x < at; };
  const auto right = std::lower_bound(polyline.begin(), polyline.end(), x, lies_left);  // first vertex that does not lie left of x
  if (right == polyline.end()) return polyline.back().y;
  if (right->x == x) {
    const auto past = std::find_if(right, polyline.end(), [x](Vec2 point) { return point.x > x; });
    return std::max_element(right, past, is_lower)->y;
  }
  if (right == polyline.begin()) return right->y;
  const Vec2 left = *(right - 1);
  return left.y + (right->y - left.y) * (x - left.x) / (right->x - left.x);
}

}  // namespace slidezone
