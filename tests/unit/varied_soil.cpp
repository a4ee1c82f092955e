// Scenes: random fields of soils, and soil that varies from point to point.
#include "scene/varied_soil.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "scene_texts.hpp"

namespace slidezone {
namespace {

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

}  // namespace
}  // namespace slidezone
