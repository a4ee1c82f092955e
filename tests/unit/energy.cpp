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

}  // namespace
}  // namespace slidezone
