#include "reach/reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slidezone {
namespace {

/// A slope of 4 x 2 m, points every 0.5 m in cells of 1 m: crest at x = 3, toe at x = 4.
struct Lattice {
  std::vector<double> x, y, x0, y0, volume;
  Lattice() {
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 4; ++j) {
        x.push_back(0.25 + 0.5 * i);
        y.push_back(0.25 + 0.5 * j);
      }
    x0 = x;
    y0 = y;
    volume.assign(x.size(), 0.25);
  }
  ReachOfRun measured() const {
    return reach({x, y, x0, y0, volume}, {.crest = {3, 2}, .toe = {4, 0}, .cell_x = 1, .cell_y = 1, .spacing_x = 0.5, .spacing_y = 0.5});
  }
};

TEST(Reach, IsZeroWhereNothingMoved) {
  const ReachOfRun reached = Lattice().measured();
  EXPECT_FALSE(reached.has_slid);
  EXPECT_EQ(reached.runout, 0);
  EXPECT_EQ(reached.influence, 0);
  EXPECT_EQ(reached.displaced_area, 0);
}

TEST(Reach, IgnoresSettlementOfTheWholeSlope) {
  Lattice points;
  for (double& y : points.y) y *= 0.6;  // the top settles by 0.7 m everywhere
  for (double& volume : points.volume) volume *= 0.6;
  points.x[31] = 5.3;  // something slides
  EXPECT_EQ(points.measured().influence, 0);
  EXPECT_FALSE(points.measured().has_reached_left_wall);
}

TEST(Reach, GoesBackToTheWallWhereTheWholeGroundFlows) {
  Lattice points;
  for (double& y : points.y) y *= 0.6;                    // the top sinks by 0.7 m everywhere, and the soil keeps its volume
  EXPECT_FALSE(points.measured().has_reached_left_wall);  // nothing moved by 1 m
  points.x[31] = 5.3;
  const ReachOfRun reached = points.measured();
  EXPECT_TRUE(reached.has_reached_left_wall);
  EXPECT_DOUBLE_EQ(reached.influence, 3.0);
}

// Drops count from the left-most column as long as it flows by less than a twentieth of the height, 0.1 m, and from its compression beyond.
TEST(Reach, LeavesTheLeftMostColumnAsReferenceOnceItFlows) {
  const auto with_flow = [](double flow) {
    Lattice points;
    for (std::size_t p = 0; p < points.x.size(); ++p) points.y[p] -= points.x[p] < 2 ? flow : 0.55;
    points.x[28] = 5.3;
    return points.measured();
  };
  EXPECT_FALSE(with_flow(0.09).has_reached_left_wall);
  EXPECT_DOUBLE_EQ(with_flow(0.09).influence, 0.0);  // 0.55 m less 0.09 m
  EXPECT_TRUE(with_flow(0.11).has_reached_left_wall);
  EXPECT_DOUBLE_EQ(with_flow(0.11).influence, 1.0);
}

// A wall that holds soil along it keeps the left-most column up while all beside it fails.
TEST(Reach, GoesBackToAWallThatHoldsTheLeftMostColumn) {
  Lattice points;
  for (std::size_t p = 0; p < points.x.size(); ++p)
    if (points.x[p] > 1) points.y[p] -= 1.2;
  ReachSettings settings{.crest = {3, 2}, .toe = {4, 0}, .cell_x = 1, .cell_y = 1, .spacing_x = 0.5, .spacing_y = 0.5};
  const Displaced displaced{points.x, points.y, points.x0, points.y0, points.volume};
  EXPECT_FALSE(reach(displaced, settings).has_reached_left_wall);
  settings.held_at_left = 2;
  EXPECT_TRUE(reach(displaced, settings).has_reached_left_wall);
  settings.held_at_left = 0.5;  // the failure ends 1 m from the wall
  EXPECT_FALSE(reach(displaced, settings).has_reached_left_wall);
}

TEST(Reach, FollowsABodyThatLeavesTheWall) {
  Lattice points;
  for (double& x : points.x) x += 10;
  EXPECT_DOUBLE_EQ(points.measured().runout, 10);
}

TEST(Reach, GoesBackToAWallWhoseColumnIsEmpty) {
  Lattice points;
  for (double& x : points.x) x += 1.5;
  EXPECT_TRUE(points.measured().has_reached_left_wall);
  EXPECT_DOUBLE_EQ(points.measured().influence, 3.0);
}

TEST(Reach, MeasuresTheFrontOfTheBodyThatHangsTogether) {
  Lattice points;
  points.x[31] = 4.3;  // the next cell still touches the body
  points.y[31] = 0.25;
  points.x[30] = 9.6;  // thrown ahead
  const ReachOfRun reached = points.measured();
  EXPECT_TRUE(reached.has_slid);
  EXPECT_DOUBLE_EQ(reached.runout, 4.3 + 0.25 - 4);
  EXPECT_DOUBLE_EQ(reached.runout_max, 9.6 + 0.25 - 4);
  EXPECT_DOUBLE_EQ(reached.displaced_area, 2 * 0.25);
}

TEST(Reach, MeasuresInfluenceFromTheCrestBack) {
  Lattice points;
  for (std::size_t p = 0; p < points.x.size(); ++p)
    if (points.x[p] > 2) points.y[p] *= 0.65;  // the columns beyond x = 2 lose 0.6 m
  const ReachOfRun reached = points.measured();
  EXPECT_DOUBLE_EQ(reached.influence, 1.0);  // crest at 3, first failed column starts at 2
  EXPECT_EQ(reached.influence_1m, 0);
}

TEST(Reach, InfluenceIsTheDecimalThatItLooksLike) {
  // One point in each column of 0.2 m; the crest is at 20 m, and the columns from 16.2 m on drop. In doubles 20 - 81 * 0.2 is above 3.8.
  std::vector<double> x, y(125, 5.0), volume(125, 0.04);
  for (int column = 0; column < 125; ++column) x.push_back(0.2 * (column + 0.5));
  const std::vector<double> before = y;
  std::fill(y.begin() + 81, y.end(), 4.0);
  const ReachOfRun reached = reach({x, y, x, before, volume},
                                   {.crest = {20, 5}, .toe = {25, 0}, .cell_x = 0.2, .cell_y = 0.2, .spacing_x = 0.2, .spacing_y = 0.2});
  EXPECT_EQ(reached.influence, 3.8);
}

TEST(Reach, CountsAnEmptyColumnAsFailed) {
  Lattice points;
  for (std::size_t p = 0; p < points.x.size(); ++p)
    if (points.x[p] > 1) points.x[p] += 3;
  EXPECT_DOUBLE_EQ(points.measured().influence, 2.0);
}

TEST(ColumnTops, SayWhereThereIsNothing) {
  const std::vector<double> x = {0.5, 2.5};
  const std::vector<double> y = {1, 2};
  const std::vector<double> tops = column_tops(x, y, 1, 0.5);
  ASSERT_EQ(tops.size(), 3u);
  EXPECT_EQ(tops[0], 1.25);
  EXPECT_TRUE(std::isnan(tops[1]));
}

}  // namespace
}  // namespace slidezone
