// From the nodes to the points of a block: velocity gradients; and the points' new velocities, with their momentum back to the nodes.
// Included by sweeps.cpp alone.
#pragma once

#include "mpm/block_nodes.hpp"
#include "mpm/block_stress.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

template <class Real>
[[gnu::always_inline]] inline void gather_gradients(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                    BlockGradients<Real>& gradients) {
  const Four<Real> per_length = two_of_each(static_cast<Real>(1 / data.grid.cell_y), static_cast<Real>(1 / data.grid.cell_x));
  const Real* node_velocity = data.node_new_velocity;
  const std::ptrdiff_t rows = data.storage.rows;
  Ahead ahead;
  if (data.fetches_ahead) {
    ahead.add(weights.s_x);
    ahead.add(weights.s_y);
    ahead.add(weights.first_node);
    ahead.add(data.softening_strain + block.first);
    ahead.add(data.peak_cohesion + block.first);
    for (const Real* stress : {data.xx, data.yy, data.zz}) ahead.add(stress + block.first);
  }
  BlockFours<Real> of_points;
  gather_points<Slopes<Real>>(
      block, weights.first_node, node_velocity, rows,
      [&](int p, const auto& velocity)
          __attribute__((always_inline)) { (per_length * velocity.value(weights, p)).store(of_points + 4 * p); },
      [&]() __attribute__((always_inline)) { ahead.fetch_some(); });
  ahead.fetch_rest();
  separate(block, of_points, gradients.xy, gradients.yy, gradients.xx, gradients.yx);
}

enum class Damping { yes, no };
enum class SecondMap { yes, no };

/// v += sum N dv, with damping drawn by grid_part towards sum N v; movement = dt sum N v; and with a second map the new momentum to the
/// nodes. Returns the energy that the drawing took.
template <SecondMap second_map, Damping damping, class Real>
[[gnu::always_inline]] inline double follow_nodes(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights) {
  Real* velocity = data.velocity + 2 * block.first;
  Real* movement = data.movement + 2 * block.first;
  const Real* mass = data.mass + block.first;
  const Real* node_motion = data.node_motion;
  Real* node_momentum = data.node_new_momentum;
  const int* first_node = weights.first_node;
  const std::ptrdiff_t rows = data.storage.rows;
  const Real step = static_cast<Real>(data.step);
  const Real grid_part = static_cast<Real>(data.grid_part);
  Pair<Real> damped{};
  const auto new_momentum = [&](int p, const Values<Real>& motion) __attribute__((always_inline)) {
    const Four<Real> from_nodes = motion.value(weights, p);
    const Pair<Real> moving = high(from_nodes);
    const Pair<Real> free = Pair<Real>::load(velocity + 2 * p) + low(from_nodes);
    Pair<Real> now = free;
    if constexpr (damping == Damping::yes) {
      now = fused(grid_part, moving - free, free);
      damped = fused(mass[p], free * free - now * now, damped);
    }
    now.store(velocity + 2 * p);
    (step * moving).store(movement + 2 * p);
    return mass[p] * now;
  };
  if constexpr (second_map == SecondMap::no) {
    gather_points<Values<Real>>(block, first_node, node_motion, rows, new_momentum);
  } else if constexpr (eight_fit<Real>) {
    gather_and_give<Values<Real>, PairSums<Real>>(
        block, first_node, node_motion, node_momentum,
        rows, [&](int p, const auto& motion, auto& sums) __attribute__((always_inline)) { sums.add(weights, p, new_momentum(p, motion)); });
  } else {  // too few registers for both at once
    BlockPairs<Real> momentum;
    gather_points<Values<Real>>(
        block, first_node, node_motion,
        rows, [&](int p, const auto& motion) __attribute__((always_inline)) { new_momentum(p, motion).store(momentum + 2 * p); });
    give_to_nodes<PairSums<Real>>(
        block, first_node, node_momentum,
        rows, [&](int p, auto& sums) __attribute__((always_inline)) { sums.add(weights, p, Pair<Real>::load(momentum + 2 * p)); });
  }
  Real lost[2];
  damped.store(lost);
  return 0.5 * (static_cast<double>(lost[0]) + static_cast<double>(lost[1]));
}

}  // namespace
}  // namespace slidezone
