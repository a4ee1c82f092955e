// Scenes: what accepted files become. Which files are refused with which words is the matter of tests/scene_schema.py.
#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/file.hpp"
#include "scene_texts.hpp"

namespace slidezone {
namespace {

// ---- the file ----

TEST(Scene, HasDefaults) {
  const Scene scene = parse(least, run_needs);
  EXPECT_EQ(scene.name, "s.toml");
  EXPECT_EQ(scene.title, "");
  EXPECT_EQ(scene.discretization.points_per_cell, 2);
  const Material& clay = scene.layers.at(0).material;
  EXPECT_EQ(clay.residual_cohesion, 20e3);
  EXPECT_EQ(clay.peak_friction_angle, 0);
  EXPECT_EQ(clay.residual_friction_angle, 0);
  EXPECT_EQ(clay.dilation_angle, 0);
  EXPECT_EQ(clay.softening_threshold, 0);
  EXPECT_EQ(clay.softening_shape, 0);
  EXPECT_TRUE(std::isinf(clay.tension_cutoff));
  EXPECT_TRUE(scene.layers[0].top.empty());
  EXPECT_EQ(scene.boundaries.base, BaseContact::bilateral);
  EXPECT_EQ(scene.boundaries.left, Wall::roller);
  EXPECT_EQ(scene.boundaries.right, Wall::open);
  EXPECT_EQ(scene.gravity.protocol, GravityProtocol::ramp);
  EXPECT_EQ(scene.gravity.ramp_time, 2);
  EXPECT_EQ(scene.gravity.acceleration.x, 0);
  EXPECT_EQ(scene.gravity.acceleration.y, -9.81);
  EXPECT_EQ(scene.initial_velocity.x, 0);
  EXPECT_EQ(scene.initial_velocity.y, 0);
  EXPECT_FALSE(scene.gravity.k0);
  EXPECT_FALSE(scene.time.step);
  EXPECT_EQ(scene.time.step_fraction, 0.5);
  EXPECT_FALSE(scene.time.rest);
  EXPECT_TRUE(scene.fields.empty());
  EXPECT_EQ(scene.output.influence_drop, 0.5);
  EXPECT_EQ(scene.output.slid_displacement, 1);
  EXPECT_EQ(scene.study.seed, 1u);
  EXPECT_EQ(scene.study.realizations, 1000u);
}

TEST(Scene, ReadsEveryKey) {
  const Scene scene = read_scene(SLIDEZONE_SOURCE "/tests/scenes/layers.toml", {true, true, true, true});
  EXPECT_EQ(scene.title, "Two layers and a berm");
  EXPECT_EQ(scene.slope.surface.size(), 6u);
  EXPECT_EQ(scene.discretization.grid.cell_x, 0.5);
  EXPECT_EQ(scene.discretization.grid.cell_y, 0.25);
  EXPECT_EQ(scene.discretization.grid.cells_x, 40);
  EXPECT_EQ(scene.discretization.grid.cells_y, 24);
  EXPECT_EQ(scene.discretization.points_per_cell, 1);
  ASSERT_EQ(scene.layers.size(), 2u);
  const Material& fill = scene.layers[0].material;
  EXPECT_DOUBLE_EQ(fill.density, 18e3 / 9.81);
  EXPECT_DOUBLE_EQ(fill.youngs_modulus, 5e6);
  EXPECT_EQ(fill.poisson_ratio, 0.3);
  EXPECT_DOUBLE_EQ(fill.peak_cohesion, 5e3);
  EXPECT_DOUBLE_EQ(fill.residual_cohesion, 5e3);
  EXPECT_DOUBLE_EQ(fill.peak_friction_angle, std::numbers::pi / 6);
  EXPECT_DOUBLE_EQ(fill.residual_friction_angle, 25 * std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(fill.dilation_angle, std::numbers::pi / 36);
  EXPECT_DOUBLE_EQ(fill.tension_cutoff, 1e3);
  EXPECT_EQ(fill.softening_threshold, 0.05);
  EXPECT_EQ(fill.softening_shape, 5);
  EXPECT_EQ(scene.layers[1].name, "clay");
  EXPECT_EQ(scene.layers[1].material.density, 2000);
  EXPECT_DOUBLE_EQ(scene.layers[1].material.residual_cohesion, 4e3);
  EXPECT_EQ(scene.layers[1].top.size(), 2u);
  EXPECT_EQ(scene.boundaries.base, BaseContact::unilateral);
  EXPECT_EQ(scene.boundaries.base_friction, 0.3);
  EXPECT_EQ(scene.boundaries.left, Wall::stick);
  EXPECT_EQ(scene.boundaries.right, Wall::roller);
  EXPECT_DOUBLE_EQ(scene.gravity.acceleration.x, 9.81 * std::sin(std::numbers::pi / 60));  // towards the toe
  EXPECT_DOUBLE_EQ(scene.gravity.acceleration.y, -9.81 * std::cos(std::numbers::pi / 60));
  EXPECT_EQ(scene.initial_velocity.x, 0.5);
  EXPECT_EQ(scene.initial_velocity.y, -0.1);
  EXPECT_EQ(scene.time.end, 60);
  EXPECT_EQ(scene.time.step_fraction, 0.4);
  EXPECT_EQ(scene.time.rest.value().energy_fraction, 0.02);
  EXPECT_EQ(scene.time.rest.value().strain_fraction, 0.003);
  EXPECT_EQ(scene.time.rest.value().hold, 3);
  ASSERT_EQ(scene.fields.size(), 1u);
  const FieldModel& field = scene.fields[0].model;
  EXPECT_EQ(scene.fields[0].parameter, Parameter::cohesion);
  EXPECT_EQ(scene.fields[0].name, "cohesion");
  EXPECT_EQ(scene.fields[0].soils, (std::vector<std::size_t>{0, 1}));
  EXPECT_DOUBLE_EQ(field.marginal.mean, 20e3);
  EXPECT_EQ(field.marginal.cov, 0.25);
  EXPECT_EQ(field.correlation.horizontal_scale, 10);
  EXPECT_EQ(field.correlation.vertical_scale, 1);
  EXPECT_EQ(field.mesh.cells_x, 40);  // 20 m in cells of 0.5 m
  EXPECT_EQ(field.mesh.cells_y, 20);  // 5 m in cells of 0.25 m
  EXPECT_EQ(scene.study.seed, 7u);
  EXPECT_EQ(scene.study.realizations, 100u);
}

TEST(Scene, ReadsTheOtherChoices) {
  const Scene scene = read_scene(SLIDEZONE_SOURCE "/tests/scenes/cut.toml", run_needs);
  EXPECT_EQ(scene.boundaries.base, BaseContact::stick);
  EXPECT_EQ(scene.gravity.protocol, GravityProtocol::k0);
  EXPECT_EQ(scene.gravity.k0, 0.5);
  EXPECT_DOUBLE_EQ(scene.time.step.value(), 1e-3);
  EXPECT_EQ(scene.layers.at(1).material.peak_cohesion, 0);
}

TEST(Scene, WantsOnlyTheTablesThatAToolNeeds) {
  EXPECT_EQ(parse(slope_text).slope.toe.x, 6);
  EXPECT_EQ(message_of([] { parse(slope_text, {.grid = true}); }), "s.toml:1:1: no table [grid] in the scene");
  EXPECT_EQ(message_of([] { parse(slope_text, {.soil = true}); }), "s.toml:1:1: no table [soil] in the scene");
  EXPECT_EQ(message_of([] { parse(slope_text, {.time = true}); }), "s.toml:1:1: no table [time] in the scene");
  EXPECT_EQ(message_of([] { parse(slope_text, {.field = true}); }), "s.toml:1:1: no table [field] in the scene");
}

TEST(Scene, ChecksTablesThatAToolDoesNotNeed) {
  EXPECT_EQ(message_of([] { parse(slope_text + "[study]\nseed = -1\n"); }).substr(0, 12), "s.toml:6:8: ");
}

TEST(Scene, ChecksumIsThatOfTheBytes) {
  EXPECT_EQ(parse(least).checksum, parse(least).checksum);
  EXPECT_NE(parse(least).checksum, parse(least + "\n").checksum);
}

/// Files damaged in one place are read or refused, never more than that: no crash, no other exception.
TEST(Scene, SurvivesDamageAnywhere) {
  const std::string whole = read_input(SLIDEZONE_SOURCE "/tests/scenes/layers.toml");
  int refused = 0;
  for (std::size_t place = 0; place < whole.size(); ++place)
    for (const char* damage : {"", "0", "-", "\"", "[", "\xff"}) {
      const std::string damaged = whole.substr(0, place) + damage + whole.substr(place + 1);
      try {
        parse(damaged, run_needs);
      } catch (const Error& error) {
        ASSERT_EQ(error.code(), ExitCode::data) << error.what();
        ASSERT_TRUE(std::string(error.what()).starts_with("s.toml:")) << error.what();
        ++refused;
      }
    }
  EXPECT_GT(refused, static_cast<int>(whole.size()));
}

// ---- the site ----

/// The bearing, in degrees, of a slope from crest to toe.
double bearing_to(const std::string& toe) {
  const std::string text =
      "[slope]\nheight = \"5 m\"\nlength = \"25 m\"\nangle = \"45 deg\"\n[site]\nepsg = 25832\ncrest = [\"100 m\", \"200 m\"]\ntoe = " +
      toe;
  return parse_scene(text, "s.toml", {.site = true}).site->bearing * 180 / std::numbers::pi;
}

TEST(Site, FacesFromCrestToToeClockwiseFromNorth) {
  EXPECT_NEAR(bearing_to("[\"100 m\", \"205 m\"]"), 0, 1e-12);
  EXPECT_NEAR(bearing_to("[\"105 m\", \"200 m\"]"), 90, 1e-12);
  EXPECT_NEAR(bearing_to("[\"100 m\", \"195 m\"]"), 180, 1e-12);
  EXPECT_NEAR(bearing_to("[\"95 m\", \"200 m\"]"), 270, 1e-12);
  EXPECT_NEAR(bearing_to("[\"105 m\", \"200 m\"]\nbearing = \"30 deg\""), 30, 1e-12);
}

}  // namespace
}  // namespace slidezone
