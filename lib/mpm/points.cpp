#include "mpm/points.hpp"

#include <numeric>
#include <type_traits>
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

/// `each` values a point. The spare array saves fresh memory for every array, which would take a third longer.
template <std::size_t each, class Value>
static void pick(PointNumbers<Value>& values, std::span<const int> order, PointNumbers<Value>& spare) {
  if (values.empty()) return;
  spare.resize(values.size());
  Value* to = spare.data();
  for (const int from : order)
    for (std::size_t k = 0; k < each; ++k) *to++ = values[each * static_cast<std::size_t>(from) + k];
  values.swap(spare);
}

template <class Real>
void reorder(PointsOf<Real>& points, std::span<const int> order) {
  PointNumbers<Real> spare;
  for (auto* pairs : {&points.velocity, &points.movement}) pick<2>(*pairs, order, spare);
  for (auto* values : {&points.xx, &points.yy, &points.zz, &points.xy, &points.mass, &points.volume, &points.plastic_strain,
                       &points.softening_strain, &points.peak_cohesion})
    pick<1>(*values, order, spare);
  PointNumbers<double> spare_places;
  for (auto* places : {&points.x, &points.y}) pick<1>(*places, order, spare_places);
  PointNumbers<int> spare_numbers;
  for (auto* numbers : {&points.soil, &points.label}) pick<1>(*numbers, order, spare_numbers);
}

template void reorder(PointsOf<double>&, std::span<const int>);
template void reorder(PointsOf<float>&, std::span<const int>);

template <class To, class From>
static PointNumbers<To> converted_values(const PointNumbers<From>& values) {
  PointNumbers<To> result;
  result.reserve(values.size());
  for (const From value : values) result.push_back(static_cast<To>(value));
  return result;
}

template <class To, class From>
PointsOf<To> converted(PointsOf<From> points) {
  if constexpr (std::is_same_v<To, From>) {
    return points;
  } else {
    const auto in = [](const PointNumbers<From>& values) { return converted_values<To>(values); };
    return {.x = std::move(points.x),
            .y = std::move(points.y),
            .velocity = in(points.velocity),
            .movement = in(points.movement),
            .xx = in(points.xx),
            .yy = in(points.yy),
            .zz = in(points.zz),
            .xy = in(points.xy),
            .mass = in(points.mass),
            .volume = in(points.volume),
            .plastic_strain = in(points.plastic_strain),
            .softening_strain = in(points.softening_strain),
            .peak_cohesion = in(points.peak_cohesion),
            .soil = std::move(points.soil),
            .label = std::move(points.label)};
  }
}

template PointsOf<double> converted(PointsOf<double>);
template PointsOf<double> converted(PointsOf<float>);
template PointsOf<float> converted(PointsOf<double>);

}  // namespace slidezone
