// Nodes of the background grid: which of them a step touches.
#include "mpm/nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mpm/simulation.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

constexpr int reached_end = 6;  // rows that points reach, of 40
constexpr int far_above = 30;

template <class Real>
NodesOf<Real> filled_nodes() {
  NodesOf<Real> nodes(NodeStorage({1, 1, 10, 34}));
  for (std::size_t node = 0; node < nodes.storage.count(); ++node) {
    nodes.sums[4 * node + 1] = 6;  // kg/s
    nodes.sums[4 * node + 2] = 2;  // kg/m
  }
  std::fill(nodes.ends.begin(), nodes.ends.end(), reached_end);
  return nodes;
}

template <class Real>
void expect_that_steps_leave_out_what_lies_above() {
  NodesOf<Real> nodes = filled_nodes<Real>();
  const NodeBox box = {0, nodes.storage.columns, 0, nodes.storage.rows};
  const Boundaries open = {.base = BaseContact::two_body, .left = Wall::open, .right = Wall::open};
  const NodeSettings settings = {{1, 1, 10, 34}, open, 1e-9, 0.1};
  const std::vector<Vec2> none(static_cast<std::size_t>(nodes.storage.columns));
  NodeEnergies energies;
  update_velocities(nodes, energies, box, {0, 0}, settings, {none, none});
  const auto velocity = [&](int row) { return nodes.motion[4 * nodes.storage.index(5, row) + 3]; };
  EXPECT_EQ(velocity(0), 3);
  EXPECT_EQ(velocity(reached_end - 1), 3);
  EXPECT_EQ(velocity(far_above), 0);
  const auto mass = [&](int row) { return nodes.sums[4 * nodes.storage.index(5, row) + 2]; };
  EXPECT_EQ(mass(reached_end - 1), 0);  // cleared for the next step
  EXPECT_EQ(mass(far_above), 2);        // not looked at: in a run it is 0 anyway
  EXPECT_EQ(nodes.mass[nodes.storage.index(5, reached_end - 1)], 2);
  begin_step(nodes, box);
  EXPECT_EQ(nodes.ends[5], 0);
}

TEST(Nodes, StepsLeaveOutWhatLiesAboveThePoints) {
  expect_that_steps_leave_out_what_lies_above<double>();
  expect_that_steps_leave_out_what_lies_above<float>();
}

// A block that flies reaches other nodes in each step, and leaves others behind: all must be found clean.
TEST(Nodes, AreCleanWhereverABlockFlies) {
  for (const Vec2 velocity : {Vec2{2, 1}, Vec2{-2, -1}}) {
    Model model = block(3, 1.3, 3, 6, elastic);
    model.gravity.acceleration = {0, 0};
    throw_all(model, velocity.x, velocity.y);
    model.time.end = 1;
    const Outcome thrown = simulate(model);
    for (std::size_t p = 0; p < thrown.points.count(); ++p) {
      ASSERT_NEAR(thrown.points.x[p], model.points.x[p] + velocity.x * thrown.time, 1e-9);
      ASSERT_NEAR(thrown.points.y[p], model.points.y[p] + velocity.y * thrown.time, 1e-9);
    }
  }
}

}  // namespace
}  // namespace slidezone
