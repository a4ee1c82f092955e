// Material point method: friction on the base beyond Coulomb's law.
#include "mpm/coulomb_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

const NodeStorage storage(GridShape{1, 1, 10, 5});

/// The base's impulse on the node of a column that slides to the right at 2 m/s.
NodeFriction push(int column, double along, double upward) {
  return {.node = storage.index(column, NodeStorage::padding),
          .push = {along, upward},
          .slip = 2,
          .tangent = {1, 0},
          .force = 0,
          .before = 2,
          .after = 2,
          .is_held = false};
}

TEST(CoulombWatch, FindsNothingWhereFrictionIsLawful) {
  CoulombWatch watch(0.5, 2, storage);
  EXPECT_EQ(watch.see({push(3, -0.5, 1), push(4, -0.1, 1)}), 0);
  EXPECT_EQ(watch.see({push(3, -1, 2), push(4, -0.1, 1)}), 0);
}

// Pressed by 3 N s, then pulled by 1 N s: friction took 1.5 N s where 1 N s is lawful, a third of its work too much.
TEST(CoulombWatch, CountsWhatTheBasePulls) {
  CoulombWatch watch(0.5, 2, storage);
  EXPECT_EQ(watch.see({push(3, -1.5, 3)}), 0);
  EXPECT_NEAR(watch.see({push(3, 0, -1)}), 1.5 * 2 / 3, 1e-12);
  EXPECT_EQ(watch.excess(), 0);  // a new window
}

// Column 4 is pulled, and all of its friction is too much; column 3 carries more than it rubs, and does not make up for it.
TEST(CoulombWatch, LooksAtColumnsOneByOne) {
  CoulombWatch watch(0.5, 1, storage);
  EXPECT_NEAR(watch.see({push(3, -1, 9), push(4, -1, -1)}), 2, 1e-12);
}

// A body that rocks: its front carries 3 N s and rubs lawfully, its rear is held down by 1 N s without friction.
TEST(CoulombWatch, LooksAtColumnsTogether) {
  CoulombWatch watch(0.5, 1, storage);
  EXPECT_NEAR(watch.see({push(3, 0, -1), push(4, -1.5, 3)}), 1.5 * 2 / 3, 1e-12);
}

TEST(CoulombWatch, GoesOnWithTheWindowOfAnotherRun) {
  CoulombWatch whole(0.5, 3, storage), first(0.5, 3, storage), second(0.5, 3, storage);
  const std::vector<std::vector<NodeFriction>> steps = {{push(3, -1.5, 3)}, {push(4, -1, 1)}, {push(3, 0, -1)}, {push(5, -1, 1)}, {}, {}};
  double of_whole = 0;
  for (const auto& step : steps) of_whole += whole.see(step);
  double of_parts = 0;
  for (std::size_t k = 0; k < 4; ++k) of_parts += first.see(steps[k]);
  second.go_on(first.columns(), 4);
  for (std::size_t k = 4; k < steps.size(); ++k) of_parts += second.see(steps[k]);
  EXPECT_EQ(of_parts, of_whole);
  EXPECT_GT(of_whole, 0);
}

/// A block of 1.2 x 0.4 m thrown along a rough base at 5 m/s, and how far it slides.
Model thrown_block(const Material& soil) {
  Model model = block(0.4, 0, 6, 2, soil);
  throw_all(model, 5, 0);
  model.boundaries.left = Wall::open;
  model.boundaries.base_friction = 0.5;
  model.gravity.protocol = GravityProtocol::k0;
  for (std::size_t p = 0; p < model.points.count(); ++p) model.points.yy[p] = -2000 * 9.81 * (0.4 - model.points.y[p]);
  model.time.end = 2;
  return model;
}

double way_of(const Model& model, const Outcome& outcome) {
  double sum = 0;
  for (std::size_t p = 0; p < model.points.count(); ++p) sum += outcome.points.x[p] - model.points.x[p];
  return sum / static_cast<double>(model.points.count());
}

// v^2 / (2 mu g) = 2.548 m. On a base that holds both ways a stiff block stops a quarter short or more while its energies balance; a
// unilateral one with a short step lets it go as far as it should.
TEST(CoulombWatch, TellsOfElasticBlocksThatStopShort) {
  constexpr double way = 25 / (2 * 0.5 * 9.81);
  Material stiff = elastic;
  stiff.youngs_modulus = 1e7;
  Model model = thrown_block(stiff);
  model.time.step_fraction = 0.1;
  const Outcome held = simulate(model);
  EXPECT_LT(way_of(model, held), 0.75 * way);
  EXPECT_LT(std::abs(held.energy.missing()), 0.05 * held.energy.least_work);
  EXPECT_GT(held.energy.error(), 0.2);
  model.boundaries.base = BaseContact::unilateral;
  const Outcome free = simulate(model);
  EXPECT_NEAR(way_of(model, free), way, 0.03 * way);
  EXPECT_NEAR(free.energy.friction_excess, 0, 1e-9);
}

TEST(CoulombWatch, FindsNothingWithoutFriction) {
  Model model = thrown_block(elastic);
  model.boundaries.base_friction = 0;
  model.boundaries.left = Wall::roller;
  for (double& x : model.points.x) x -= 0.4;  // at the wall
  throw_all(model, -1, 0);
  const Outcome outcome = simulate(model);
  EXPECT_EQ(outcome.energy.friction_work, 0);
  EXPECT_EQ(outcome.energy.friction_excess, 0);
}

}  // namespace
}  // namespace slidezone
