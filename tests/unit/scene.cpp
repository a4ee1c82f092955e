#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace slidezone {
namespace {

/// A small scene that has every table and leaves every optional key out.
const std::string least = R"([slope]
height = "2 m"
length = "6 m"
angle = "45 deg"
[grid]
cell = "0.5 m"
width = "10 m"
height = "3 m"
[[soil]]
name = "clay"
density = "2000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
cohesion = "20 kPa"
[base]
friction = 0.3
[time]
end = "5 s"
)";

TEST(Scene, HasDefaults) {
  const Scene scene = parse_scene(least, "s.toml", {true, true, true, false});
  EXPECT_EQ(scene.name, "s.toml");
  EXPECT_EQ(scene.discretization.points_per_cell, 2);
  EXPECT_EQ(scene.discretization.grid.cells_x, 20);
  const Material& clay = scene.layers.at(0).material;
  EXPECT_EQ(clay.residual_cohesion, 20e3);
  EXPECT_EQ(clay.peak_friction_angle, 0);
  EXPECT_EQ(clay.residual_friction_angle, 0);
  EXPECT_TRUE(std::isinf(clay.tension_cutoff));
  EXPECT_EQ(scene.boundaries.base, BaseContact::bilateral);
  EXPECT_EQ(scene.boundaries.left, Wall::roller);
  EXPECT_EQ(scene.boundaries.right, Wall::open);
  EXPECT_EQ(scene.gravity.protocol, GravityProtocol::ramp);
  EXPECT_EQ(scene.gravity.acceleration.y, -9.81);
  EXPECT_FALSE(scene.time.step);
  EXPECT_FALSE(scene.time.rest);
  EXPECT_TRUE(scene.fields.empty());
}

TEST(Scene, ReadsTheBenchmark) {
  const Scene scene = read_scene(SLIDEZONE_SOURCE "/pipelines/benchmark/scene.toml", {true, true, true, false});
  EXPECT_NEAR(scene.slope.crest.x, 20, 1e-12);  // 25 - 5 / tan(45 deg), rounded
  EXPECT_EQ(scene.slope.toe.x, 25);
  EXPECT_EQ(scene.discretization.grid.cells_x, 501);
  EXPECT_EQ(scene.discretization.grid.cells_y, 52);
  EXPECT_DOUBLE_EQ(scene.layers[0].material.density, 20e3 / 9.81);
  EXPECT_EQ(material_points(scene).x.size(), 11225u);
}

}  // namespace
}  // namespace slidezone
