// Material point method: what single precision may change.
#include <gtest/gtest.h>

#include <cmath>

#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

TEST(SinglePrecision, AgreesWithDouble) {
  const Outcome expected = simulate(deforming_block());
  const Outcome found = simulate(in_single_precision(deforming_block()));
  EXPECT_EQ(found.steps, expected.steps);
  EXPECT_GT(worst_distance(found.points, expected.points), 0);     // it is another kernel
  EXPECT_LT(worst_distance(found.points, expected.points), 1e-5);  // 1e-7 of 0.5 m a run, times what softening makes of it
}

TEST(SinglePrecision, ClosesTheEnergyBalanceAsDoubleDoes) {
  Model model = block(0, 0, 6, 6, clay);
  model.boundaries.base_friction = 0.1;
  model.time.end = 1;
  model.time.step_fraction = 0.02;  // some 20,000 steps
  const Outcome expected = simulate(model);
  const Outcome found = simulate(in_single_precision(model));
  EXPECT_LT(std::abs(expected.energy.error()), 0.02);
  EXPECT_NEAR(found.energy.error(), expected.energy.error(), 1e-3);
}

TEST(SinglePrecision, LosesNoSmallMovement) {
  // A step moves the block by 8e-8 m at 7 m from the origin, where floats are 5e-7 m apart and would not move at all.
  Model model = block(7, 2, 2, 2, elastic);
  model.gravity.acceleration = {0, 0};
  throw_all(model, 1e-4, 0);
  model.time.step_fraction = 0.1;
  const Outcome outcome = simulate(in_single_precision(model));
  EXPECT_NEAR(outcome.points.x[0] - model.points.x[0], 1e-4 * outcome.time,
              1e-8);  // of 5e-5 m; noise of the lightest nodes at its rim is 2e-9 m
}

TEST(SinglePrecision, KeepsSoilAtRest) {
  Model model = block(0, 0, 10, 10, elastic);
  model.grid = {0.2, 0.2, 10, 14};
  model.boundaries.right = Wall::roller;
  model.time.end = 10;
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    model.points.yy[p] = -2000 * 9.81 * (2 - model.points.y[p]);
    model.points.xx[p] = model.points.zz[p] = 3. / 7 * model.points.yy[p];
  }
  const auto moved = [](const Model& start) { return worst_distance(simulate(start).points, start.points); };
  EXPECT_NEAR(moved(in_single_precision(model)), moved(model), 1e-6);
}

TEST(SinglePrecision, BeginsWithAnElasticStageOfItsOwn) {
  Model model = in_single_precision(block(0, 0, 6, 6, clay));
  model.boundaries.base_friction = 0.3;
  model.gravity.protocol = GravityProtocol::ramp;
  model.gravity.ramp_time = 0.5;
  const Outcome whole = simulate(model);
  model.stage = elastic_stage(model);
  ASSERT_TRUE(model.stage);
  const Outcome resumed = simulate(model);
  EXPECT_EQ(resumed.points.x, whole.points.x);
  EXPECT_EQ(resumed.points.xx, whole.points.xx);
}

}  // namespace
}  // namespace slidezone
