// Material point method: steps that are refused, runs that end early, and the rest rule.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

// ---- guards -----------------------------------------------------------------------------------------------------------------------

TEST(Guards, RefuseAStepBeyondTheLimit) {
  Model model = block(1, 1, 2, 2, elastic);
  model.time.step = 1.01 * step_limit(model);
  EXPECT_THROW(simulate(model), Error);
}

TEST(Guards, LetATestTakeALongerStep) {
  Model model = block(1, 1, 2, 2, elastic);
  model.time.step = 1.01 * step_limit(model);
  model.refuses_long_steps = false;
  EXPECT_EQ(time_step(model), model.time.step);
}

TEST(Guards, StepLimitIsThatOfTheBenchmark) {
  Material soil{.density = 20e3 / 9.81, .youngs_modulus = 1e6, .poisson_ratio = 0.33};
  EXPECT_NEAR(step_limit(block(1, 1, 1, 1, soil)), 7.4e-3, 5e-5);
}

TEST(Guards, StepLimitIsWhatTheMethodAllows) {
  Model model = block(1, 1, 2, 2, elastic);
  const double full = step_limit(model);
  const auto part = [&](UpdateOrder order, ShapeFunctions shape) {
    model.method.update_order = order;
    model.method.shape_functions = shape;
    return step_limit(model) / full;
  };
  EXPECT_EQ(part(UpdateOrder::usf, ShapeFunctions::gimp), 1);
  EXPECT_DOUBLE_EQ(part(UpdateOrder::musl, ShapeFunctions::linear), 0.5);
  EXPECT_DOUBLE_EQ(part(UpdateOrder::usl, ShapeFunctions::gimp), std::sqrt(2 * 0.7 * 0.1875 / 1.75));  // l = 1/4, nu = 0.3
  EXPECT_EQ(part(UpdateOrder::usl, ShapeFunctions::linear), 0);
  EXPECT_THROW(time_step(model), Error);  // half of nothing is no step
}

TEST(Guards, EndARunWhoseMaterialLeaves) {
  Model model = block(6.6, 1, 2, 2, elastic);
  throw_all(model, 10, 0);
  const Outcome outcome = simulate(model);
  EXPECT_EQ(outcome.ending, Ending::left_domain);
  EXPECT_NE(outcome.trouble.find("lies outside the grid of 8 x 4 m at step "), std::string::npos) << outcome.trouble;
}

TEST(Guards, NameThePointOfARunThatBreaks) {
  Model model = block(3, 1, 2, 2, elastic);
  model.points.velocity[2 * 5] = std::numeric_limits<double>::quiet_NaN();
  const Outcome outcome = simulate(model);
  EXPECT_EQ(outcome.ending, Ending::diverged);
  EXPECT_NE(outcome.trouble.find("not finite at step "), std::string::npos) << outcome.trouble;
}

TEST(Guards, EndARunThatCrossesACellInAStep) {
  Model model = block(3, 1, 2, 2, {.density = 2000, .youngs_modulus = 1, .poisson_ratio = 0});
  throw_all(model, 20, 0);
  model.time = {.end = 1, .step = 0.03, .step_fraction = 0.5, .rest = {}};
  const Outcome outcome = simulate(model);
  EXPECT_EQ(outcome.ending, Ending::diverged);
  EXPECT_EQ(outcome.trouble, "point 0 moved by more than a cell at step 1, time 0.03 s");
}

// ---- rest -------------------------------------------------------------------------------------------------------------------------

TEST(Rest, EndsARunThatCameToRest) {
  Model model = block(0, 0, 6, 6, clay);
  model.boundaries.base_friction = 0.5;
  model.time.end = 30;
  model.time.rest = RestRule{.energy_fraction = 0.01, .strain_fraction = 0.001, .hold = 1};
  const Outcome outcome = simulate(model);
  EXPECT_EQ(outcome.ending, Ending::at_rest);
  EXPECT_NEAR(outcome.time - outcome.rest_time, 1, 0.01);
}

TEST(Rest, WaitsForSoilThatStillYields) {
  const auto end = [](double strain_fraction) {
    Model model = block(0, 0, 6, 6, clay);
    model.boundaries.base_friction = 0.5;
    model.time.end = 30;
    model.time.rest = RestRule{.energy_fraction = 0.5, .strain_fraction = strain_fraction, .hold = 0.2};
    return simulate(model).time;
  };
  EXPECT_GT(end(0.001), 1.5 * end(0.9));
}

}  // namespace
}  // namespace slidezone
