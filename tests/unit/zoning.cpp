#include "zoning/zoning.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "zoning/map_frame.hpp"

namespace slidezone {
namespace {

/// 1, 2, ... count.
Sample ladder(std::size_t count) {
  Sample sample;
  for (std::size_t i = 1; i <= count; ++i) sample.push_back({static_cast<double>(i), Knowledge::exact});
  return sample;
}

TEST(Classes, EndAtTheirThresholdInclusive) {
  const Classes classes;
  EXPECT_EQ(class_of(classes, 1), "very_high");
  EXPECT_EQ(class_of(classes, 0.5), "high");
  EXPECT_EQ(class_of(classes, 0.100001), "high");
  EXPECT_EQ(class_of(classes, 0.1), "medium");
  EXPECT_EQ(class_of(classes, 0.01), "low");
  EXPECT_EQ(class_of(classes, 0.001), "very_low");
  EXPECT_EQ(class_of(classes, 0), "very_low");
  EXPECT_EQ(class_of(classes, std::numeric_limits<double>::quiet_NaN()), "unknown");
}

TEST(Boundaries, CarryOrderStatisticIntervals) {
  const std::vector<Boundary> found = boundaries(ladder(1000), Classes{});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].name, "very_high");
  EXPECT_EQ(found[0].distance.value, 500.5);
  EXPECT_EQ(found[0].distance.interval.low, 469);  // the binomial's 95 % ranks of the median of 1000 runs
  EXPECT_EQ(found[0].distance.interval.high, 532);
  EXPECT_EQ(found[3].name, "low");
  EXPECT_EQ(found[3].distance.interval.low, 997);
  EXPECT_TRUE(std::isinf(found[3].distance.interval.high));
}

TEST(Boundaries, AgreeWithTheCurve) {
  const Sample sample = ladder(1000);
  for (const Boundary& boundary : boundaries(sample, Classes{}))
    EXPECT_DOUBLE_EQ(exceedance_estimate(sample, boundary.distance.value).value, boundary.probability);
}

TEST(Boundaries, ByTailReplaceOnlyThoseBeyondItsShare) {
  Sample sample = ladder(1000);
  for (Observation& seen : sample) seen.value = std::log(1000.5 / (1000.5 - seen.value));  // quantiles of an exponential
  const TailFit tail = *tail_fit(known_values(sample));
  const std::vector<Boundary> plain = boundaries(sample, Classes{});
  const std::vector<Boundary> fitted = boundaries_by_tail(sample, Classes{}, tail);
  EXPECT_EQ(fitted[0].distance.value, plain[0].distance.value);
  EXPECT_NE(fitted[2].distance.value, plain[2].distance.value);
  EXPECT_NEAR(fitted[3].distance.value, std::log(1000.0), 0.3);  // the fit's shape is off zero by its few hundredths
  EXPECT_FALSE(std::isinf(fitted[3].distance.interval.high));
}

TEST(Curve, FallsFromOneAndStandsBesideItsFits) {
  std::vector<double> slides;
  for (int i = 1; i <= 100; ++i) slides.push_back(i);
  const std::vector<double> distances = {0, 50.5, 100};
  const std::vector<CurvePoint> curve = exceedance_curve(ladder(100), slides, 0.8, distances);
  EXPECT_EQ(curve[0].exceedance.value, 1);
  EXPECT_EQ(curve[1].exceedance.value, 0.5);
  EXPECT_EQ(curve[2].exceedance.value, 0);
  EXPECT_NEAR(curve[1].normal, 0.8 * 0.5, 1e-15);  // at the mean of the slides
  EXPECT_EQ(curve[0].lognormal, 0.8);
}

TEST(Curve, HasNoFitOfEqualValues) {
  const std::vector<double> slides(5, 0.0);
  const std::vector<CurvePoint> curve = exceedance_curve(ladder(5), slides, 1, std::vector<double>{1});
  EXPECT_TRUE(std::isnan(curve[0].normal));
  EXPECT_TRUE(std::isnan(curve[0].lognormal));
}

TEST(CurveDistances, AreRoundAndCoverTheData) {
  for (const double farthest : {1e-3, 0.7, 1.0, 9.32, 27.0, 1600.0}) {
    const std::vector<double> distances = curve_distances(farthest);
    EXPECT_EQ(distances.front(), 0);
    EXPECT_GE(distances.back(), 1.25 * farthest);
    EXPECT_GE(distances.size(), 201u) << farthest;
    EXPECT_LE(distances.size(), 502u) << farthest;
  }
  EXPECT_EQ(curve_distances(27)[3], 0.3);
  EXPECT_EQ(curve_distances(0).back(), 1.25);  // nothing moved: one metre to look at
}

// ---- map ----

double area(const std::array<Vec2, 5>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < 4; ++i) twice += ring[i].x * ring[i + 1].y - ring[i + 1].x * ring[i].y;
  return twice / 2;
}

TEST(MapFrame, RunsAwayFromTheSlopeOnBothSides) {
  const MapFrame east{{100, 200}, {105, 200}, std::numbers::pi / 2, 30};
  EXPECT_NEAR(place_at(east, Side::toe, 10).x, 115, 1e-12);
  EXPECT_NEAR(place_at(east, Side::toe, 10).y, 200, 1e-12);
  EXPECT_NEAR(place_at(east, Side::crest, 10).x, 90, 1e-12);
  const MapFrame north{{100, 200}, {100, 205}, 0, 30};
  EXPECT_EQ(place_at(north, Side::toe, 10).y, 215);
}

TEST(MapFrame, StripsAreClosedAndCounterClockwise) {
  for (const double bearing : {0.0, 0.3, 2.5, 4.0}) {
    const MapFrame frame{{100, 200}, {103, 204}, bearing, 30};
    for (const Side side : {Side::toe, Side::crest}) {
      const std::array<Vec2, 5> strip = strip_between(frame, side, 2, 5);
      EXPECT_NEAR(area(strip), 3 * 30, 1e-9);  // positive: counter-clockwise
      EXPECT_EQ(strip.front().x, strip.back().x);
      EXPECT_EQ(strip.front().y, strip.back().y);
    }
  }
}

}  // namespace
}  // namespace slidezone
