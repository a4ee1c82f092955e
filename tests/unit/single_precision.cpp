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

TEST(SinglePrecision, GivesTheSameOnEveryInstructionSet) {
  const Outcome plain = simulate(in_single_precision(deforming_block()), {}, Kernel{InstructionSet::baseline, {}});
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512_in_halves, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    const Points found = simulate(in_single_precision(deforming_block()), {}, Kernel{set, {}}).points;
    EXPECT_LT(worst_distance(found, plain.points), 1e-5);  // rounding of sums in another order, as against double
  }
}

/// Farthest that a point ends from where it does in double, m. Floats are good to 3e-8 m of the 0.5 m that points move; what softening and
/// contact make of that was 3e-6 m at most.
double error_of(const Model& model) { return worst_distance(simulate(in_single_precision(model)).points, simulate(model).points); }

TEST(SinglePrecision, AgreesWithDoubleInEveryMethod) {
  for (const UpdateOrder order : {UpdateOrder::musl, UpdateOrder::usl, UpdateOrder::usf})
    for (const ShapeFunctions shape : {ShapeFunctions::gimp, ShapeFunctions::linear})
      for (const AntiLocking locking : {AntiLocking::none, AntiLocking::b_bar}) {
        const bool is_refused =
            order == UpdateOrder::usf ? locking == AntiLocking::b_bar : order == UpdateOrder::usl && shape == ShapeFunctions::linear;
        if (is_refused) continue;
        Model model = deforming_block();
        model.method = {.update_order = order, .shape_functions = shape, .anti_locking = locking};
        EXPECT_LT(error_of(model), 1e-5) << static_cast<int>(order) << static_cast<int>(shape) << static_cast<int>(locking);
      }
}

/// A block of clay that slumps on the base.
Model slumping_block() {
  Model model = block(1, 0, 6, 6, clay);
  model.boundaries.base_friction = 0.3;
  model.time.step_fraction = 0.1;
  return model;
}

TEST(SinglePrecision, AgreesWithDoubleOnEveryBase) {
  for (const BaseContact base : {BaseContact::bilateral, BaseContact::unilateral, BaseContact::stick, BaseContact::two_body}) {
    Model model = slumping_block();
    model.boundaries.base = base;
    EXPECT_LT(error_of(model), 1e-5) << static_cast<int>(base);
  }
}

TEST(SinglePrecision, AgreesWithDoubleInEverySoil) {
  const auto error = [](auto change) {
    Model model = slumping_block();
    change(model);
    return error_of(model);
  };
  EXPECT_LT(error([](Model& model) { model.nonlocal_softening = NonlocalSoftening{0.6, 2}; }), 1e-5);
  EXPECT_LT(error([](Model& model) { model.soils[0].peak_friction_angle = 0.4, model.soils[0].dilation_angle = 0.1; }), 1e-5);
  EXPECT_LT(error([](Model& model) { model.soils[0].tension_cutoff = 0; }), 1e-5);
  EXPECT_LT(error([](Model& model) { model.soils[0].softening_shape = 1e6; }), 1e-5);
  EXPECT_LT(error([](Model& model) { model.soils[0].poisson_ratio = 0.49, model.method.anti_locking = AntiLocking::b_bar; }), 1e-5);
  EXPECT_LT(error([](Model& model) { model.soils[0].youngs_modulus = 1e9; }), 1e-3);  // shakes on its base for 18,000 steps: 2e-4
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
