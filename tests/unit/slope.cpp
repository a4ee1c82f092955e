// Scenes: the slope, and the material points that fill it.
#include "scene/slope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "scene_texts.hpp"

namespace slidezone {
namespace {

// ---- the slope ----

TEST(Slope, FollowsFromHeightLengthAndAngle) {
  const std::vector<Vec2> surface = straight_slope(5, 25, std::numbers::pi / 4);
  const Slope slope = slope_of(surface);
  EXPECT_NEAR(slope.crest.x, 20, 1e-12);  // tan(pi / 4) is rounded
  EXPECT_EQ(slope.crest.y, 5);
  EXPECT_EQ(slope.toe.x, 25);
  EXPECT_EQ(slope.toe.y, 0);
}

TEST(Slope, MayBeVertical) {
  const Scene scene = parse("[slope]\nheight = \"100 m\"\nlength = \"10 m\"\nangle = \"90 deg\"\n");
  EXPECT_EQ(scene.slope.crest.x, 10);
  EXPECT_EQ(scene.slope.toe.x, 10);
}

TEST(Slope, CrestEndsTheHighestPartAndToeBeginsTheLowest) {
  const Slope slope = slope_of({{0, 5}, {5, 6}, {10, 6}, {12, 3}, {14, 3}, {16, 1}, {18, 1}, {20, 2}});
  EXPECT_EQ(slope.crest.x, 10);
  EXPECT_EQ(slope.toe.x, 16);
  EXPECT_EQ(slope.toe.y, 1);
}

TEST(Elevation, IsLinearBetweenVerticesAndConstantBeyond) {
  const std::vector<Vec2> line = {{1, 2}, {3, 4}, {3, 1}, {5, 1}};
  const std::map<double, double> expected = {{0, 2}, {1, 2}, {2, 3}, {2.5, 3.5}, {3, 4}, {4, 1}, {5, 1}, {9, 1}};
  for (const auto& [x, y] : expected) EXPECT_EQ(elevation(line, x), y) << x;
  EXPECT_EQ(elevation({{0, 3}}, -1), 3);  // a single level
  EXPECT_EQ(elevation({{0, 3}}, 8), 3);
}

// ---- material points ----

TEST(MaterialPoints, OfTheBenchmarkAre11225) {
  // 200 full columns of 50 points, and 49 + 48 + ... + 0 below the face: those on it are outside.
  const Scene scene = read_scene(SLIDEZONE_SOURCE "/pipelines/benchmark/scene.toml", run_needs);
  const MaterialPoints points = material_points(scene);
  EXPECT_EQ(points.x.size(), 11225u);
  EXPECT_EQ(points.y.size(), 11225u);
  EXPECT_EQ(std::count(points.layer.begin(), points.layer.end(), 0), 11225);
  EXPECT_DOUBLE_EQ(points.spacing_x, 0.1);
  EXPECT_DOUBLE_EQ(points.x[0], 0.05);
  EXPECT_DOUBLE_EQ(points.y[1], 0.15);  // column by column, from the base up
}

/// Points of a slope of height 2 m on cells of 0.5 m; `face` is the rest of its surface after the left wall.
std::vector<int> column_heights(const std::string& face) {
  const std::string surface = "[slope]\nsurface = [[\"0 m\", \"2 m\"], " + face + "]\n";
  const MaterialPoints points = material_points(parse(surface + grid_text + soil_text + "[walls]\nright = \"roller\"\n"));
  std::vector<int> heights(40);
  for (const double x : points.x) ++heights[static_cast<std::size_t>(x / points.spacing_x)];
  return {heights.begin(), std::find(heights.begin(), heights.end(), 0)};
}

TEST(MaterialPoints, OnASlantingFaceAreOutside) {
  // The face passes through lattice points; the surface of 2 m is 8 spacings high.
  EXPECT_EQ(column_heights("[\"0.5 m\", \"2 m\"], [\"2.5 m\", \"0 m\"]"), (std::vector<int>{8, 8, 7, 6, 5, 4, 3, 2, 1}));
}

TEST(MaterialPoints, OnAVerticalFaceAreOutside) {
  EXPECT_EQ(column_heights("[\"0.625 m\", \"2 m\"], [\"0.625 m\", \"0 m\"]"), (std::vector<int>{8, 8}));
  EXPECT_EQ(column_heights("[\"0.626 m\", \"2 m\"], [\"0.626 m\", \"0 m\"]"), (std::vector<int>{8, 8, 8}));
}

TEST(MaterialPoints, FollowABerm) {
  EXPECT_EQ(column_heights("[\"0.5 m\", \"2 m\"], [\"0.5 m\", \"1 m\"], [\"1 m\", \"1 m\"], [\"1 m\", \"0 m\"]"),
            (std::vector<int>{8, 8, 4, 4}));
}

TEST(MaterialPoints, ReachTheRightWallUnderGroundThatDoes) {
  const std::vector<int> heights = column_heights("[\"0.5 m\", \"2 m\"], [\"1.5 m\", \"1 m\"], [\"10 m\", \"1 m\"]");
  EXPECT_EQ(heights.size(), 40u);
  EXPECT_EQ(heights.back(), 4);
}

/// A face whose points lie on the lattice whatever the spacing: the count does not hang on how the cell is rounded.
TEST(MaterialPoints, DoNotDependOnRounding) {
  for (const int cells : {3, 7, 10, 13, 30, 70, 110}) {
    Scene scene = parse(slope_text);
    scene.discretization = {{2.0 / cells, 2.0 / cells, 6 * cells, 2 * cells}, 1};
    scene.layers.resize(1);
    const auto n = static_cast<std::size_t>(cells);
    EXPECT_EQ(material_points(scene).x.size(), 2 * n * n + n * (n - 1) / 2) << cells;
  }
}

TEST(MaterialPoints, BelongToTheLastLayerThatCoversThem) {
  const std::string second = "[[soil]]\nname = \"sand\"\ndensity = \"2 t/m^3\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = 0.3\n";
  const std::string strength = "cohesion = \"1 kPa\"\n";
  const MaterialPoints level = material_points(parse(least + second + strength + "top = \"0.625 m\"\n"));
  for (std::size_t point = 0; point < level.x.size(); ++point)
    ASSERT_EQ(level.layer[point], level.y[point] < 0.6 ? 1 : 0) << level.y[point];  // those at 0.625 m lie on the boundary, above it

  const MaterialPoints slanting = material_points(parse(least + second + strength + "top = [[\"0 m\", \"0 m\"], [\"4 m\", \"2 m\"]]\n"));
  for (std::size_t point = 0; point < slanting.x.size(); ++point)
    ASSERT_EQ(slanting.layer[point], slanting.y[point] < slanting.x[point] / 2 ? 1 : 0) << slanting.x[point] << ' ' << slanting.y[point];
}

TEST(MaterialPoints, MustFillEverySoil) {
  const std::string second = "[[soil]]\nname = \"sand\"\ndensity = \"2 t/m^3\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = 0.3\n";
  EXPECT_EQ(message_of([&] { material_points(parse(least + second + "cohesion = \"1 kPa\"\ntop = \"0.1 m\"\n")); }),
            "s.toml: no material point lies in soil \"sand\", with points every 0.25 m by 0.25 m; move the tops of the soils or refine the "
            "grid");
  EXPECT_TRUE(message_of([&] {
                material_points(parse(least + second + "cohesion = \"1 kPa\"\ntop = \"30 m\"\n"));
              }).starts_with("s.toml: no material point lies in soil \"clay\","));
}

TEST(MaterialPoints, MustExist) {
  const std::string sliver = "[slope]\nsurface = [[\"0 m\", \"5 cm\"], [\"1 m\", \"10 cm\"], [\"2 m\", \"0 m\"]]\n";
  EXPECT_EQ(message_of([&] { material_points(parse(sliver + grid_text + soil_text)); }),
            "s.toml: no material point lies inside the slope, with points every 0.25 m by 0.25 m; refine the grid");
}

}  // namespace
}  // namespace slidezone
