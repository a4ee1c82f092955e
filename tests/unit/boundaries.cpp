// Material point method: contact with the base.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

double mean_x(const Points& points) { return std::accumulate(points.x.begin(), points.x.end(), 0.) / static_cast<double>(points.count()); }

TEST(Base, StopsASlidingBlockByFriction) {
  Model model = block(1, 0, 3, 1, elastic);
  model.boundaries.base_friction = 0.3;
  model.boundaries.left = Wall::open;
  model.gravity.protocol = GravityProtocol::k0;  // at rest under its weight from the start, so that it does not chatter
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    model.points.yy[p] = -2000 * 9.81 * (0.2 - model.points.y[p]);
    model.points.xx[p] = model.points.zz[p] = 0;
  }
  throw_all(model, 3, 0);
  model.time.end = 1.5;
  const Outcome outcome = simulate(model);
  // v^2 / (2 mu g) = 1.529 m; the elastic block swings as it slides, which spreads the contact pressure: 2 %.
  EXPECT_NEAR(mean_x(outcome.points) - mean_x(model.points), 9 / (2 * 0.3 * 9.81), 0.02 * 1.529);
  EXPECT_LT(std::abs(outcome.energy.missing()), 0.01 * outcome.energy.friction_work);
}

TEST(Base, LetsNothingSinkThrough) {
  Model model = block(0, 0, 6, 6, clay);
  model.boundaries.base_friction = 0.1;
  model.time.end = 3;
  model.time.step_fraction = 0.1;
  const Outcome outcome = simulate(model);
  EXPECT_EQ(outcome.ending, Ending::at_end) << outcome.trouble;
  EXPECT_GT(*std::max_element(outcome.points.x.begin(), outcome.points.x.end()), 2.0);  // it spread
  EXPECT_GE(*std::min_element(outcome.points.y.begin(), outcome.points.y.end()), 0);
  EXPECT_GE(*std::min_element(outcome.points.x.begin(), outcome.points.x.end()), 0);
  EXPECT_LT(std::abs(outcome.energy.error()), 0.02);  // six cells are few: 2.5 % at half the step limit, 1.4 % at a tenth
}

TEST(TwoBodyBase, StopsASlidingBlockByFriction) {
  Model model = block(1, 0, 48, 2, elastic);
  model.grid = {0.2, 0.2, 80, 10};
  model.boundaries.base = BaseContact::two_body;
  model.boundaries.base_friction = 0.3;
  model.boundaries.left = Wall::open;
  model.gravity.protocol = GravityProtocol::k0;
  for (std::size_t p = 0; p < model.points.count(); ++p) model.points.yy[p] = -2000 * 9.81 * (0.4 - model.points.y[p]);
  throw_all(model, 3, 0);
  model.time.end = 1.5;
  model.time.step_fraction = 0.1;
  const Outcome outcome = simulate(model);
  // Normals lean at the block's ends, which adds resistance there: 1.18, 1.36, 1.46, 1.51 m at 6, 12, 24, 48 cells of length.
  EXPECT_NEAR(mean_x(outcome.points) - mean_x(model.points), 9 / (2 * 0.3 * 9.81), 0.03 * 1.529);
}

TEST(TwoBodyBase, LetsSoilLiftOff) {
  Model model = block(3, 0, 3, 2, elastic);
  model.boundaries.base = BaseContact::two_body;
  throw_all(model, 0, 1);
  model.time.end = 0.1;
  const Outcome outcome = simulate(model);
  EXPECT_GT(*std::min_element(outcome.points.y.begin(), outcome.points.y.end()), 0.08);
}

}  // namespace
}  // namespace slidezone
