#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "io/file.hpp"
#include "scene/slope.hpp"
#include "scene/varied_soil.hpp"

// Which files are refused with which words is the matter of tests/scene_schema.py; here is what accepted files become.

namespace slidezone {
namespace {

constexpr Needs no_needs{};
constexpr Needs run_needs{.grid = true, .soil = true, .time = true};

/// The message of the Error that `act` throws; fails the test if it throws none.
std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::data) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

/// A scene of its own tables only: those that the others need, with every optional key left out.
const std::string slope_text = "[slope]\nheight = \"2 m\"\nlength = \"6 m\"\nangle = \"45 deg\"\n";
const std::string grid_text = "[grid]\ncell = \"0.5 m\"\nwidth = \"10 m\"\nheight = \"3 m\"\n";
const std::string soil_text =
    "[[soil]]\nname = \"clay\"\ndensity = \"2000 kg/m^3\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = 0.3\ncohesion = \"20 kPa\"\n";
const std::string run_text = "[base]\nfriction = 0.3\n[time]\nend = \"5 s\"\n";
const std::string least = slope_text + grid_text + soil_text + run_text;

Scene parse(const std::string& text, Needs needs = no_needs) { return parse_scene(text, "s.toml", needs); }

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

// ---- fields ----

TEST(Field, HasDefaults) {
  const std::string field =
      "[field.cohesion]\nmean = \"30 kPa\"\ncov = 0.5\nhorizontal_scale = \"2 m\"\nvertical_scale = \"1 m\"\ncell = \"1 m\"\n";
  const FieldModel model = parse(least + field).fields.at(0).model;
  EXPECT_EQ(model.correlation.function, Autocorrelation::single_exponential);
  EXPECT_EQ(model.correlation.shape, LagShape::separable);
  EXPECT_EQ(model.correlation.bedding_angle, 0);
  EXPECT_EQ(model.correlation.nugget, 0);
  EXPECT_EQ(model.method, Method::automatic);
}

TEST(Field, NamesStandForTheirFunctions) {
  const auto field = [](const std::string& lines) {
    return parse(least +
                 "[field.cohesion]\nmean = \"30 kPa\"\ncov = 0.5\nhorizontal_scale = \"2 m\"\nvertical_scale = \"1 m\"\ncell = \"1 m\"\n" +
                 lines)
        .fields.at(0)
        .model;
  };
  EXPECT_EQ(field("autocorrelation = \"squared exponential\"").correlation.function, Autocorrelation::squared_exponential);
  EXPECT_EQ(field("autocorrelation = \"third-order Markov\"").correlation.function, Autocorrelation::third_order_markov);
  EXPECT_EQ(field("autocorrelation = \"spherical\"").correlation.function, Autocorrelation::spherical);
  EXPECT_EQ(field("autocorrelation = \"Matern\"\nsmoothness = 2").correlation.smoothness, 2);
  EXPECT_EQ(field("lag = \"elliptical\"").correlation.shape, LagShape::elliptical);
  EXPECT_NEAR(field("bedding_angle = \"-45 deg\"").correlation.bedding_angle, -std::numbers::pi / 4, 1e-15);
  EXPECT_EQ(field("correlation_of = \"physical\"").correlation_of, CorrelationOf::physical);
  EXPECT_EQ(field("marginal = \"Weibull\"").marginal.distribution, Distribution::weibull);
  EXPECT_EQ(field("marginal = \"truncated normal\"\nlow = \"10 kPa\"\nhigh = \"40 kPa\"").marginal.high, 40e3);
  EXPECT_EQ(field("method = \"circulant\"").method, Method::circulant);
  EXPECT_EQ(field("method = \"Karhunen-Loeve\"\nvariance_kept = 0.5").variance_kept, 0.5);
}

TEST(Field, OfASoilStandsInPlaceOfThatOfAll) {
  const Scene scene = read_scene(SLIDEZONE_SOURCE "/tests/scenes/varied.toml", {true, true, true, true});
  std::vector<std::string> names;
  for (const FieldSpec& spec : scene.fields) names.push_back(spec.name);
  EXPECT_EQ(names, (std::vector<std::string>{"cohesion", "friction_angle", "youngs_modulus", "unit_weight", "cohesion.clay",
                                             "residual_cohesion.clay", "friction_angle.clay", "unit_weight.clay"}));
  using Soils = std::vector<std::size_t>;
  EXPECT_EQ(scene.fields[0].soils, Soils{0});
  EXPECT_EQ(scene.fields[2].soils, (Soils{0, 1}));
  EXPECT_EQ(scene.fields[4].soils, Soils{1});
  EXPECT_NEAR(scene.fields[1].model.marginal.mean, std::numbers::pi / 6, 1e-15);
  ASSERT_EQ(scene.cross_correlations.size(), 2u);
  EXPECT_EQ(scene.cross_correlations[0].fields, (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(scene.cross_correlations[0].matrix[2][1], 0.3);
  EXPECT_EQ(scene.cross_correlations[1].fields, (std::vector<std::size_t>{4, 5}));
  EXPECT_EQ(scene.cross_correlations[1].correlation_of, CorrelationOf::physical);
}

TEST(Field, TrendFollowsTheDepthBelowTheGround) {
  const Scene scene = read_scene(SLIDEZONE_SOURCE "/tests/scenes/varied.toml", {true, true, true, true});
  const FieldModel& model = scene.fields[4].model;  // cells of 0.25 m; the ground is at 2 m up to x = 4 m, then falls by 45 degrees
  EXPECT_EQ(model.trend.spread, Spread::constant_sd);
  EXPECT_EQ(model.trend.gradient, 1000);
  EXPECT_DOUBLE_EQ(model.trend.depth[0], 2 - 0.125);
  EXPECT_DOUBLE_EQ(model.trend.depth[7 * 24], 0.125);
  EXPECT_NEAR(model.trend.depth[2 * 24 + 20], 0.875 - 0.625, 1e-12);  // at x = 5.125 m, y = 0.625 m
  EXPECT_EQ(model.trend.depth[7 * 24 + 20], 0);                       // in the air
}

TEST(Field, IsNoUseWhereEverySoilHasItsOwn) {
  const std::string lines = "mean = \"30 kPa\"\ncov = 0.5\nhorizontal_scale = \"2 m\"\nvertical_scale = \"1 m\"\ncell = \"1 m\"\n";
  const std::string own = slope_text + grid_text + soil_text + "[soil.field.cohesion]\n" + lines + run_text;
  EXPECT_EQ(parse(own, {.field = true}).fields.at(0).name, "cohesion.clay");
  EXPECT_EQ(message_of([&] { parse(own + "[field.cohesion]\n" + lines); }),
            "s.toml:25:1: 'cohesion' has no use: every soil has a field of its own");
}

// ---- soil that varies ----

Layer softening_clay() {
  Layer layer;
  layer.name = "clay";
  layer.material = {.density = 2000, .youngs_modulus = 1e6, .poisson_ratio = 0.3, .peak_cohesion = 20e3, .residual_cohesion = 4e3};
  layer.material.peak_friction_angle = 0.5;
  layer.material.residual_friction_angle = 0.3;
  layer.material.dilation_angle = 0.2;
  layer.residual_cohesion_follows = layer.residual_friction_follows = false;
  return layer;
}

ParameterValues values_of(std::initializer_list<std::pair<Parameter, double>> given) {
  ParameterValues values;
  for (const auto& [parameter, value] : given) values[static_cast<std::size_t>(parameter)] = value;
  return values;
}

/// The soil with the values that are given, and how many of them stand at a limit.
std::pair<Material, std::size_t> soil_at(const Layer& layer, std::initializer_list<std::pair<Parameter, double>> given) {
  ParameterValues values = values_of(given);
  const std::size_t count = hold_within_limits(values, layer);
  return {varied_soil(layer, values), count};
}

TEST(VariedSoil, PeakStaysAboveTheResidualOfTheSoil) {
  const auto [soil, count] = soil_at(softening_clay(), {{Parameter::cohesion, 3e3}, {Parameter::friction_angle, 0.1}});
  EXPECT_EQ(soil.peak_cohesion, 4e3);
  EXPECT_EQ(soil.residual_cohesion, 4e3);
  EXPECT_EQ(soil.peak_friction_angle, 0.3);
  EXPECT_EQ(count, 2u);
  EXPECT_EQ(soil_at(softening_clay(), {{Parameter::cohesion, 4.1e3}}).second, 0u);
}

TEST(VariedSoil, ResidualFieldStaysBelowThePeak) {
  const auto [soil, count] = soil_at(softening_clay(), {{Parameter::cohesion, 3e3}, {Parameter::residual_cohesion, 3.5e3}});
  EXPECT_EQ(soil.peak_cohesion, 3e3);
  EXPECT_EQ(soil.residual_cohesion, 3e3);
  EXPECT_EQ(count, 1u);
  EXPECT_EQ(soil_at(softening_clay(), {{Parameter::residual_cohesion, 21e3}}).first.residual_cohesion, 20e3);
}

TEST(VariedSoil, ResidualThatIsNotGivenFollowsThePeak) {
  Layer plastic = softening_clay();
  plastic.residual_cohesion_follows = plastic.residual_friction_follows = true;
  const auto [soil, count] = soil_at(plastic, {{Parameter::cohesion, 3e3}, {Parameter::friction_angle, 0.1}});
  EXPECT_EQ(soil.peak_cohesion, 3e3);
  EXPECT_EQ(soil.residual_cohesion, 3e3);
  EXPECT_EQ(soil.residual_friction_angle, 0.1);
  EXPECT_EQ(soil.dilation_angle, 0.1);  // at most the friction angle
  EXPECT_EQ(count, 0u);
}

TEST(VariedSoil, TakesWeightAndStiffness) {
  const auto [soil, count] = soil_at(softening_clay(), {{Parameter::unit_weight, 19.62e3}, {Parameter::youngs_modulus, 5e6}});
  EXPECT_DOUBLE_EQ(soil.density, 2000);
  EXPECT_EQ(soil.youngs_modulus, 5e6);
  EXPECT_EQ(count, 0u);
  EXPECT_EQ(soil_at(softening_clay(), {{Parameter::friction_angle, 2}}).first.peak_friction_angle, largest_friction_angle);
}

TEST(VariedSoil, LimitsOfAFieldAreTheWidestOfItsSoils) {
  Scene scene;
  scene.layers = {softening_clay(), softening_clay()};
  scene.layers[0].material.residual_cohesion = 2e3;
  FieldSpec cohesion;
  cohesion.soils = {0, 1};
  EXPECT_EQ(limits_of(cohesion, scene).low, 2e3);
  cohesion.soils = {1};
  EXPECT_EQ(limits_of(cohesion, scene).low, 4e3);
  FieldSpec residual;
  residual.parameter = Parameter::residual_cohesion;
  residual.soils = {1};
  scene.fields = {cohesion, residual};
  EXPECT_EQ(limits_of(cohesion, scene).low, 0);
}

TEST(Field, MeshCoversTheSlope) {
  const std::string field = "[field.cohesion]\nmean = \"30 kPa\"\ncov = 0.5\nhorizontal_scale = \"2 m\"\nvertical_scale = \"1 m\"\n";
  const auto cells = [&](const std::string& cell) {
    const FieldMesh mesh = parse(least + field + "cell = " + cell + "\n").fields.at(0).model.mesh;
    return std::vector<int>{mesh.cells_x, mesh.cells_y};
  };
  EXPECT_EQ(cells("\"0.1 m\""), (std::vector<int>{60, 20}));  // 6 m by 2 m; 6 / 0.1 is rounded above 60 or not, it is 60
  EXPECT_EQ(cells("\"0.7 m\""), (std::vector<int>{9, 3}));
  EXPECT_EQ(cells("[\"10 m\", \"0.3 m\"]"), (std::vector<int>{1, 7}));
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
