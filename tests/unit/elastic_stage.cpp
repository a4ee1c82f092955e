// Material point method: runs that begin with the elastic stage of others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

/// A block of clay on a rough base under gravity that grows for 10 s; it yields after a second or more and then slides apart.
Model slowly_loaded_block() {
  Model model = block(0, 0, 10, 10, clay);
  model.boundaries.base_friction = 0.3;
  model.gravity = {{1, -9.81}, GravityProtocol::ramp, 10, {}};
  model.time.end = 6;
  return model;
}

/// The same with strength that differs from point to point, nowhere below that of `model`.
Model strengthened(Model model) {
  for (std::size_t p = 0; p < model.points.count(); ++p) model.points.peak_cohesion[p] *= 1 + 0.01 * static_cast<double>(p % 37);
  return model;
}

double largest_plastic_strain(const Outcome& outcome) {
  return *std::max_element(outcome.points.plastic_strain.begin(), outcome.points.plastic_strain.end());
}

void expect_equal_bits(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.ending, b.ending);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.points.x, b.points.x);
  EXPECT_EQ(a.points.velocity, b.points.velocity);
  EXPECT_EQ(a.points.xx, b.points.xx);
  EXPECT_EQ(a.points.plastic_strain, b.points.plastic_strain);
  EXPECT_EQ(a.energy.missing(), b.energy.missing());
  EXPECT_EQ(a.energy.friction_excess, b.energy.friction_excess);
  EXPECT_TRUE(a.rest_time == b.rest_time || (std::isnan(a.rest_time) && std::isnan(b.rest_time)));
}

TEST(ElasticStage, RunsThatBeginWithItHaveTheBitsOfWholeOnes) {
  std::vector<Model> models(9, slowly_loaded_block());
  models[1].method.update_order = UpdateOrder::usl;
  models[2].method.update_order = UpdateOrder::usf;
  models[3].method.anti_locking = AntiLocking::b_bar;
  models[4].method.shape_functions = ShapeFunctions::linear;
  models[5].nonlocal_softening = NonlocalSoftening{.length = 0.6};
  models[6].boundaries.base = BaseContact::two_body;
  models[7].method.damping_rate = 0.5;
  models[8].time.rest = RestRule{.hold = 0.5};
  for (std::size_t k = 0; k < models.size(); ++k) {
    SCOPED_TRACE(k);
    Model model = strengthened(models[k]);
    const Outcome whole = simulate(model);
    EXPECT_GT(largest_plastic_strain(whole), 0.05);
    model.stage = elastic_stage(models[k]);
    ASSERT_TRUE(model.stage);
    EXPECT_GE(model.stage->steps(), 100U);
    expect_equal_bits(simulate(model), whole);
  }
}

TEST(ElasticStage, OfARunThatIsSharedByThreads) {
  Model model = large_block(1);
  for (double& cohesion : model.points.peak_cohesion) cohesion *= 1000;
  const std::optional<ElasticStage> stage = elastic_stage(model);
  const Outcome whole = simulate(strengthened(model));
  Model rest = strengthened(model);
  rest.threads = 2;
  rest.stage = stage;
  ASSERT_TRUE(rest.stage);
  expect_equal_bits(simulate(rest), whole);
}

TEST(ElasticStage, EndsBeforeAnythingYields) {
  Model model = slowly_loaded_block();
  const std::optional<ElasticStage> stage = elastic_stage(model);
  ASSERT_TRUE(stage);
  const auto ending_after = [&](std::uint64_t steps) {
    model.time.end = static_cast<double>(steps) * time_step(model);
    return simulate(model);
  };
  EXPECT_EQ(largest_plastic_strain(ending_after(stage->steps() - 1)), 0);  // the end of a run completes the stress of one more step
  EXPECT_GT(largest_plastic_strain(ending_after(stage->steps())), 0);
}

TEST(ElasticStage, IsNotThereWhereSoilYieldsAtOnce) {
  Model model = slowly_loaded_block();
  model.points.yy.assign(model.points.count(), -1e5);
  EXPECT_FALSE(elastic_stage(model));
}

TEST(ElasticStage, OfSoilThatStandsIsAllButTheLastStepOfTheRun) {
  Model model = slowly_loaded_block();
  for (double& cohesion : model.points.peak_cohesion) cohesion = 1e9;
  model.time.rest = RestRule{.energy_fraction = 0.9, .strain_fraction = 0.9, .hold = 0.5};
  const Outcome whole = simulate(model);
  model.stage = elastic_stage(model);
  ASSERT_TRUE(model.stage);
  EXPECT_EQ(whole.steps - model.stage->steps(), 1U);
  expect_equal_bits(simulate(model), whole);
}

}  // namespace
}  // namespace slidezone
