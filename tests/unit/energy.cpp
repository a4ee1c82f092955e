// Material point method: the energy balance of a run.
#include <gtest/gtest.h>

#include <cmath>

#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

TEST(Energy, ErrorHasAMeasureWithoutGravity) {
  Model model = block(3, 3, 4, 3, elastic);
  model.gravity.acceleration = {0, 0};
  EXPECT_EQ(simulate(model).energy.error(), 0);  // nothing moves, nothing is missing
  throw_all(model, 1, 0);
  const Outcome thrown = simulate(model);
  EXPECT_NEAR(thrown.energy.least_work, 0.5 * 48 * 20, 1e-9);  // 48 points of 20 kg/m at 1 m/s
  EXPECT_NEAR(thrown.energy.error(), 0, 1e-9);
}

TEST(Energy, ErrorOfSoilThatStandsIsMeasuredByASmallFall) {
  Model model = block(0, 0, 2, 10, elastic);
  model.gravity.protocol = GravityProtocol::k0;
  for (std::size_t p = 0; p < model.points.count(); ++p) model.points.yy[p] = -2000 * 9.81 * (2 - model.points.y[p]);
  const Outcome outcome = simulate(model);
  EXPECT_NEAR(outcome.energy.least_work, 80 * 20 * 9.81 * 2e-3, 1e-9);  // 80 points of 20 kg/m, 2 mm
  EXPECT_LT(std::abs(outcome.energy.gravity_work), outcome.energy.least_work);
  EXPECT_LT(std::abs(outcome.energy.error()), 0.01);
}

// Soil slides on above the nodes that a rough base holds: friction takes energy there that the nodes' own velocity does not show.
// Counted by that velocity, it missed 2.8 and 3.1 %.
TEST(Energy, CountsWhatSoilLosesToFriction) {
  Model model = block(0, 0, 20, 20, clay);
  model.time.end = 3;
  model.time.step_fraction = 0.4;
  for (const BaseContact contact : {BaseContact::bilateral, BaseContact::stick}) {
    model.boundaries.base = contact;
    model.boundaries.base_friction = 1;
    const Outcome outcome = simulate(model);
    EXPECT_GT(outcome.energy.friction_work, 0.02 * outcome.energy.gravity_work);
    EXPECT_NEAR(outcome.energy.error(), 0, 0.01);
  }
}

// Elastic soil that swings on a rough base. USF strains what friction holds, which gives energy; it must show as error, not as
// friction that gives.
TEST(Energy, FrictionNeverGives) {
  for (const UpdateOrder order : {UpdateOrder::musl, UpdateOrder::usl, UpdateOrder::usf}) {
    Model model = block(0, 0, 12, 12, elastic);
    model.boundaries.base_friction = 1;
    model.method.update_order = order;
    model.time.end = 3;
    const Outcome outcome = simulate(model);
    EXPECT_GE(outcome.energy.friction_work, 0);
    if (order == UpdateOrder::musl) {
      EXPECT_NEAR(outcome.energy.error(), 0, 0.01);
    } else if (order == UpdateOrder::usf) {
      EXPECT_LT(outcome.energy.error(), -0.05);
    }
  }
}

// With linear shape functions the force of a point jumps where it crosses the edge of a cell, and a body whose points lie there
// exactly may shake itself to pieces at a step that is stable elsewhere.
TEST(Energy, TellsOfPointsOnEdgesOfCells) {
  Model model = block(0.05, 0.05, 12, 12, elastic);
  model.boundaries.base_friction = 1;
  model.time.end = 3;
  EXPECT_NEAR(simulate(model).energy.error(), 0, 0.02);
  model.method = {.update_order = UpdateOrder::usf, .shape_functions = ShapeFunctions::linear};
  EXPECT_LT(simulate(model).energy.error(), -1);
}

}  // namespace
}  // namespace slidezone
