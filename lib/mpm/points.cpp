#include "mpm/points.hpp"

#include <numeric>
#include <utility>

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
static void pick(std::vector<Value>& values, const std::vector<int>& order) {
  if (values.empty()) return;
  std::vector<Value> result;
  result.reserve(values.size());
  for (const int from : order) result.push_back(values[static_cast<std::size_t>(from)]);
  values = std::move(result);
}

static void pick_pairs(std::vector<double>& pairs, const std::vector<int>& order) {
  std::vector<double> result;
  result.reserve(pairs.size());
  for (const int from : order) {
    const auto first = 2 * static_cast<std::size_t>(from);
    result.push_back(pairs[first]);
    result.push_back(pairs[first + 1]);
  }
  pairs = std::move(result);
}

void reorder(Points& points, const std::vector<int>& order) {
  for (auto* values : {&points.x, &points.y, &points.xx, &points.yy, &points.zz, &points.xy, &points.mass, &points.volume,
                       &points.plastic_strain, &points.softening_strain, &points.peak_cohesion})
    pick(*values, order);
  for (auto* pairs : {&points.velocity, &points.movement}) pick_pairs(*pairs, order);
  for (auto* values : {&points.soil, &points.label}) pick(*values, order);
}

}  // namespace slidezone
