#include "mpm/points.hpp"

#include <numeric>

namespace slidezone {

Points points_at_rest(std::size_t count) {
  Points points;
  for (auto* values : {&points.x, &points.y, &points.xx, &points.yy, &points.zz, &points.xy, &points.mass, &points.volume,
                       &points.plastic_strain, &points.peak_cohesion})
    values->assign(count, 0.0);
  points.velocity.assign(2 * count, 0.0);
  points.movement.assign(2 * count, 0.0);
  points.soil.assign(count, 0);
  points.label.resize(count);
  std::iota(points.label.begin(), points.label.end(), 0);
  return points;
}

template <class Value>
static std::vector<Value> picked(const std::vector<Value>& values, const std::vector<int>& order) {
  if (values.empty()) return {};
  std::vector<Value> result;
  result.reserve(values.size());
  for (const int from : order) result.push_back(values[static_cast<std::size_t>(from)]);
  return result;
}

static std::vector<double> picked_pairs(const std::vector<double>& pairs, const std::vector<int>& order) {
  std::vector<double> result;
  result.reserve(pairs.size());
  for (const int from : order) {
    const auto first = 2 * static_cast<std::size_t>(from);
    result.push_back(pairs[first]);
    result.push_back(pairs[first + 1]);
  }
  return result;
}

Points reordered(const Points& points, const std::vector<int>& order) {
  return {.x = picked(points.x, order),
          .y = picked(points.y, order),
          .velocity = picked_pairs(points.velocity, order),
          .movement = picked_pairs(points.movement, order),
          .xx = picked(points.xx, order),
          .yy = picked(points.yy, order),
          .zz = picked(points.zz, order),
          .xy = picked(points.xy, order),
          .mass = picked(points.mass, order),
          .volume = picked(points.volume, order),
          .plastic_strain = picked(points.plastic_strain, order),
          .softening_strain = picked(points.softening_strain, order),
          .peak_cohesion = picked(points.peak_cohesion, order),
          .soil = picked(points.soil, order),
          .label = picked(points.label, order)};
}

}  // namespace slidezone
