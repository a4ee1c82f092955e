// The order of material points in memory.
#include "mpm/point_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace slidezone {
namespace {

/// Four points of which every number tells whose it is.
template <class Real>
PointsOf<Real> numbered_points() {
  Points points = points_at_rest(4);
  for (auto* values : {&points.x, &points.y, &points.xx, &points.yy, &points.zz, &points.xy, &points.mass, &points.volume,
                       &points.plastic_strain, &points.peak_cohesion})
    std::iota(values->begin(), values->end(), 0.0);
  for (auto* pairs : {&points.velocity, &points.movement}) *pairs = {0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5};
  points.soil = {0, 1, 2, 3};
  return converted<Real>(std::move(points));
}

template <class Real>
void expect_that_all_numbers_move() {
  PointsOf<Real> points = numbered_points<Real>();
  reorder(points, std::vector{2, 0, 3, 1});
  const PointNumbers<double> places = {2, 0, 3, 1};
  const PointNumbers<Real> values = {2, 0, 3, 1};
  const PointNumbers<Real> pairs = {2, 2.5, 0, 0.5, 3, 3.5, 1, 1.5};
  const PointNumbers<int> numbers = {2, 0, 3, 1};
  for (const auto* of_points : {&points.x, &points.y}) EXPECT_EQ(*of_points, places);
  for (const auto* of_points :
       {&points.xx, &points.yy, &points.zz, &points.xy, &points.mass, &points.volume, &points.plastic_strain, &points.peak_cohesion})
    EXPECT_EQ(*of_points, values);
  for (const auto* of_points : {&points.velocity, &points.movement}) EXPECT_EQ(*of_points, pairs);
  for (const auto* of_points : {&points.soil, &points.label}) EXPECT_EQ(*of_points, numbers);
  EXPECT_TRUE(points.softening_strain.empty());
  reorder(points, order_by_label(points));
  EXPECT_EQ(points.x, (PointNumbers<double>{0, 1, 2, 3}));
}

TEST(PointOrder, MovesAllNumbersOfAPoint) {
  expect_that_all_numbers_move<double>();
  expect_that_all_numbers_move<float>();
}

TEST(PointOrder, GoesByFirstNodesAndKeepsThatOfEqualOnes) {
  EXPECT_EQ(order_by_node(std::vector{7, 9, 7, 3, 1000, 3}), (std::vector<int>{3, 5, 0, 2, 1, 4}));
  EXPECT_EQ(order_by_node(std::vector{5}), (std::vector<int>{0}));
}

}  // namespace
}  // namespace slidezone
