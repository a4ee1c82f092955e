// Material point method: choices of the method.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

TEST(Method, UpdateOrdersAgreeAsTheStepShrinks) {
  // Part of the distance is of first order in the step. Part is not: MUSL's second map smooths velocities, whatever the step.
  const auto distance = [](UpdateOrder order, double fraction) {
    Model model = deforming_block();
    model.time.step_fraction = fraction;
    const Outcome musl = simulate(model);
    model.method.update_order = order;
    return worst_distance(simulate(model).points, musl.points);
  };
  for (const UpdateOrder order : {UpdateOrder::usl, UpdateOrder::usf}) {
    EXPECT_LT(distance(order, 0.05), 0.9 * distance(order, 0.1));
    EXPECT_LT(distance(order, 0.05), 0.01);
  }
}

TEST(Method, EveryChoiceKeepsARigidFallExact) {
  for (const UpdateOrder order : {UpdateOrder::musl, UpdateOrder::usl, UpdateOrder::usf})
    for (const ShapeFunctions shape : {ShapeFunctions::gimp, ShapeFunctions::linear})
      for (const AntiLocking locking : {AntiLocking::none, AntiLocking::b_bar}) {
        if (order == UpdateOrder::usf && locking == AntiLocking::b_bar) continue;
        Model model = block(3.03, 3.07, 4, 3, elastic);
        model.method = {.update_order = order, .shape_functions = shape, .anti_locking = locking};
        model.time.end = 0.3;
        model.time.step = 2e-3;
        model.refuses_long_steps = false;  // nothing deforms, so that no step is too long
        const Outcome outcome = simulate(model);
        const double dt = outcome.time / static_cast<double>(outcome.steps);
        const double fallen = -9.81 * outcome.time * (outcome.time + dt) / 2;
        for (std::size_t p = 0; p < outcome.points.count(); ++p)
          ASSERT_NEAR(outcome.points.y[p] - model.points.y[p], fallen, 1e-8) << static_cast<int>(order) << static_cast<int>(shape);
      }
}

TEST(Method, BBarGivesAllPointsOfACellOneVolumeChange) {
  Model model = deforming_block();
  model.points = block(3, 1.2, 5, 4, clay).points;  // on cell boundaries, so that cells are whole
  for (std::size_t p = 0; p < model.points.count(); ++p) model.points.velocity[2 * p] = std::pow(model.points.x[p] - 3, 2);
  model.method.anti_locking = AntiLocking::b_bar;
  model.gravity.acceleration = {0, 0};
  model.time = {.end = 1e-3, .step = 1e-3, .step_fraction = 0.5, .rest = {}};
  const Points points = simulate(model).points;
  for (std::size_t p = 0; p + 1 < points.count(); p += 2) {
    EXPECT_NEAR(points.volume[p], points.volume[p + 1], 1e-15);  // two points of a cell, one above the other
    EXPECT_NE(points.volume[p], 0.01);
  }
  EXPECT_NEAR(points.volume[0], points.volume[8], 1e-15);  // and beside each other
}

TEST(Method, BBarKeepsNearlyIncompressibleSoilFromLocking) {
  // A block of clay slumps under its weight; at nu = 0.499 plain points lock and hardly move.
  const auto spread = [](double nu, AntiLocking locking) {
    Material soil{.density = 2000, .youngs_modulus = 1e6, .poisson_ratio = nu, .peak_cohesion = 5e3, .residual_cohesion = 5e3};
    Model model = block(0, 0, 10, 10, soil);
    model.boundaries.base_friction = 0.3;
    model.method.anti_locking = locking;
    model.time.end = 1.5;
    const Outcome outcome = simulate(model);
    return *std::max_element(outcome.points.x.begin(), outcome.points.x.end()) - 2;
  };
  const double compressible = spread(0.3, AntiLocking::b_bar);
  EXPECT_LT(spread(0.499, AntiLocking::none), 0.5 * compressible);
  EXPECT_NEAR(spread(0.499, AntiLocking::b_bar) / compressible, 1, 0.25);  // nu itself changes the slump a little
}

TEST(Method, DampingDoesNotDependOnTheStep) {
  const auto left = [](double fraction) {
    Model model = deforming_block();
    model.gravity.acceleration = {0, 0};
    model.method.damping_rate = 5;
    model.time.end = 1;
    model.time.step_fraction = fraction;
    return simulate(model);
  };
  const Outcome coarse = left(0.2);
  const Outcome fine = left(0.05);
  EXPECT_GT(coarse.energy.damping_work, 0);
  EXPECT_NEAR(coarse.energy.damping_work / fine.energy.damping_work, 1, 0.1);
}

}  // namespace
}  // namespace slidezone
