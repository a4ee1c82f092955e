#include "mpm/nodes.hpp"

#include <algorithm>
#include <cmath>

#include "core/vector_loop.hpp"

namespace slidezone {

template <class Real>
NodesOf<Real>::NodesOf(NodeStorage where)
    : storage(where),
      sums(4 * where.count()),
      force(2 * where.count()),
      mass(where.count()),
      motion(4 * where.count()),
      new_velocity(2 * where.count()),
      ends(static_cast<std::size_t>(where.columns)) {}

/// Calls act(first, count) for the run of nodes in each column of the box, without most of those above what points reach. Full vectors,
/// and one at least, which holds the base: so that sums over nodes do not depend on how far beyond the points they go.
template <class Real, class Act>
static void for_each_column(const NodesOf<Real>& nodes, const NodeBox& box, Act act) {
  constexpr int vector_size = 64 / sizeof(Real);
  for (int column = box.first_column; column < box.last_column; ++column) {
    const int reached = nodes.ends[static_cast<std::size_t>(column)] - box.first_row;
    const int in_vectors = std::max(1, (reached + vector_size - 1) / vector_size) * vector_size;
    act(nodes.storage.index(column, box.first_row), static_cast<std::size_t>(std::min(in_vectors, box.last_row - box.first_row)));
  }
}

/// The same for all nodes of the box.
template <class Real, class Act>
static void for_each_whole_column(const NodesOf<Real>& nodes, const NodeBox& box, Act act) {
  for (int column = box.first_column; column < box.last_column; ++column)
    act(nodes.storage.index(column, box.first_row), static_cast<std::size_t>(box.last_row - box.first_row));
}

template <class Real>
static void clear(NodeNumbers<Real>& values, std::size_t first, std::size_t count) {
  std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(first), count, Real{0});
}

// Where a node's numbers begin.
static std::size_t momentum_of(std::size_t node) { return 4 * node; }
static std::size_t mass_of(std::size_t node) { return 4 * node + 2; }
static std::size_t force_of(std::size_t node) { return 2 * node; }
static std::size_t change_of(std::size_t node) { return 4 * node; }
static std::size_t velocity_of(std::size_t node) { return 4 * node + 2; }
static std::size_t new_velocity_of(std::size_t node) { return 2 * node; }

template <class Real>
void begin_step(NodesOf<Real>& nodes, const NodeBox& box) {
  std::fill(nodes.ends.begin() + box.first_column, nodes.ends.begin() + box.last_column, 0);
}

template <class Real>
std::vector<double> new_velocities_in(const NodesOf<Real>& nodes, const NodeBox& box) {
  std::vector<double> result;
  for_each_whole_column(nodes, box, [&](std::size_t first, std::size_t count) {
    const auto begin = nodes.new_velocity.begin() + static_cast<std::ptrdiff_t>(2 * first);
    result.insert(result.end(), begin, begin + static_cast<std::ptrdiff_t>(2 * count));
  });
  return result;
}

template <class Real>
void set_new_velocities(NodesOf<Real>& nodes, const NodeBox& box, const std::vector<double>& velocities) {
  auto from = velocities.begin();
  for_each_whole_column(nodes, box, [&](std::size_t first, std::size_t count) {
    const auto next = from + static_cast<std::ptrdiff_t>(2 * count);
    std::transform(from, next, nodes.new_velocity.begin() + static_cast<std::ptrdiff_t>(2 * first),
                   [](double velocity) { return static_cast<Real>(velocity); });
    from = next;
  });
}

// ---- walls and base as mirrors ----------------------------------------------------------------------------------------

/// Signs that a mirror gives to the components of a velocity, momentum or force.
struct Mirror {
  float x;  // exact in any precision
  float y;
};

static Mirror mirror_of(Wall wall) { return {-1, wall == Wall::stick ? -1.f : 1.f}; }
static Mirror mirror_of(BaseContact contact) { return {contact == BaseContact::stick ? -1.f : 1.f, -1}; }

/// Calls act(behind, before, mirror) for each padding node in the box that lies behind a closed side and the node that it
/// mirrors.
template <class Real, class Act>
static void for_each_image(const NodesOf<Real>& nodes, const NodeBox& box, const NodeSettings& settings, Act act) {
  const auto columns = [&](int behind, int before, Wall wall) {
    if (wall == Wall::open || behind < box.first_column || behind >= box.last_column) return;
    for (int row = box.first_row; row < box.last_row; ++row)
      act(nodes.storage.index(behind, row), nodes.storage.index(before, row), mirror_of(wall));
  };
  if (box.first_row < NodeStorage::padding && settings.boundaries.base != BaseContact::two_body)
    for (int column = box.first_column; column < box.last_column; ++column)
      act(nodes.storage.index(column, NodeStorage::padding - 1), nodes.storage.index(column, NodeStorage::padding + 1),
          mirror_of(settings.boundaries.base));
  const int left = NodeStorage::padding;
  const int right = settings.grid.cells_x + NodeStorage::padding;
  columns(left - 1, left + 1, settings.boundaries.left);
  columns(right + 1, right - 1, settings.boundaries.right);
}

/// Pairs that begin at `behind` and `before`.
template <class Real>
static void fold_pairs(NodeNumbers<Real>& numbers, std::size_t behind, std::size_t before, Mirror mirror) {
  numbers[before] += mirror.x * numbers[behind];
  numbers[before + 1] += mirror.y * numbers[behind + 1];
  numbers[behind] = numbers[behind + 1] = 0;
}

template <class Real>
static void reflect_pairs(NodeNumbers<Real>& numbers, std::size_t behind, std::size_t before, Mirror mirror) {
  numbers[behind] = mirror.x * numbers[before];
  numbers[behind + 1] = mirror.y * numbers[before + 1];
}

// ---- walls and base as constraints --------------------------------------------------------------------------------------

/// Calls act(node) for the nodes on the left wall, on the right wall, and on the base.
template <class Real, class Act>
static void for_nodes_of_column(const NodesOf<Real>& nodes, const NodeBox& box, int column, Act act) {
  if (column < box.first_column || column >= box.last_column) return;
  for (int row = box.first_row; row < box.last_row; ++row) act(nodes.storage.index(column, row));
}
template <class Real, class Act>
static void for_nodes_left(const NodesOf<Real>& nodes, const NodeBox& box, Act act) {
  for_nodes_of_column(nodes, box, NodeStorage::padding, act);
}
template <class Real, class Act>
static void for_nodes_right(const NodesOf<Real>& nodes, const NodeBox& box, const GridShape& grid, Act act) {
  for_nodes_of_column(nodes, box, grid.cells_x + NodeStorage::padding, act);
}
template <class Real, class Act>
static void for_nodes_on_base(const NodesOf<Real>& nodes, const NodeBox& box, Act act) {
  if (box.first_row > NodeStorage::padding) return;
  for (int column = box.first_column; column < box.last_column; ++column) act(nodes.storage.index(column, NodeStorage::padding));
}

/// A node's velocity as the boundaries see it.
template <class Real>
struct NodeVelocity {
  Real& x;
  Real& y;
};

/// The pair that begins at `first`.
template <class Real>
static NodeVelocity<Real> pair_in(NodeNumbers<Real>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1]};
}

template <class Real>
static Vec2 pair_at(const NodeNumbers<Real>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1]};
}

template <class Real>
static void hold_at_wall(NodeVelocity<Real> velocity, Wall wall) {
  if (wall == Wall::open) return;
  velocity.x = 0;
  if (wall == Wall::stick) velocity.y = 0;
}

template <class Real>
static void hold_at_base(NodeVelocity<Real> velocity, BaseContact contact) {
  if (contact == BaseContact::two_body) return;
  if (contact == BaseContact::stick) velocity.x = 0;
  if (contact != BaseContact::unilateral || velocity.y < 0) velocity.y = 0;
}

/// Velocity along the base after Coulomb friction under the normal velocity change `pressed` >= 0.
static double rubbed(double along, double pressed, double friction) {
  return std::copysign(std::max(0.0, std::abs(along) - friction * pressed), along);
}

/// v = momentum / m + dv, dv = dt (f / m + g), for the nodes of one column.
template <class Real>
SLIDEZONE_VECTOR_LOOP static void balance_momentum(const Real* sums, const Real* force, Real* motion, std::size_t count, Real gravity_x,
                                                   Real gravity_y, Real least_mass, Real step) {
#pragma GCC ivdep
  for (std::size_t k = 0; k < count; ++k) {
    const Real mass = sums[4 * k + 2];
    const bool is_filled = mass > least_mass;
    const Real inverse = is_filled ? 1 / mass : 0;
    const Real fall = is_filled ? step : 0;
    const Real change_x = step * inverse * force[2 * k] + fall * gravity_x;
    const Real change_y = step * inverse * force[2 * k + 1] + fall * gravity_y;
    motion[4 * k] = change_x;
    motion[4 * k + 1] = change_y;
    motion[4 * k + 2] = sums[4 * k] * inverse + change_x;
    motion[4 * k + 3] = sums[4 * k + 1] * inverse + change_y;
  }
}

/// v = momentum / m in place, for the nodes of one column.
template <class Real>
SLIDEZONE_VECTOR_LOOP static void divide_by_mass(const Real* mass, Real* velocity, std::size_t count, Real least_mass) {
#pragma GCC ivdep
  for (std::size_t k = 0; k < count; ++k) {
    const Real inverse = mass[k] > least_mass ? 1 / mass[k] : 0;
    velocity[2 * k] *= inverse;
    velocity[2 * k + 1] *= inverse;
  }
}

/// The masses of the nodes of one column, out of their sums.
template <class Real>
SLIDEZONE_VECTOR_LOOP static void keep_mass(const Real* sums, Real* mass, std::size_t count) {
#pragma GCC ivdep
  for (std::size_t k = 0; k < count; ++k) mass[k] = sums[4 * k + 2];
}

template <class Real>
SLIDEZONE_VECTOR_LOOP static NodeMotion motion_of(const Real* mass, const Real* motion, std::size_t count) {
  double x = 0;
  double y = 0;
  double square = 0;
#pragma omp simd reduction(+ : x, y, square)
  for (std::size_t k = 0; k < count; ++k) {
    const Real velocity_x = motion[4 * k + 2];
    const Real velocity_y = motion[4 * k + 3];
    const Real along_x = mass[k] * velocity_x;
    const Real along_y = mass[k] * velocity_y;
    x += static_cast<double>(along_x);
    y += static_cast<double>(along_y);
    square += static_cast<double>(along_x * velocity_x + along_y * velocity_y);
  }
  return {{x, y}, square};
}

static void add(NodeMotion& sum, const NodeMotion& more) {
  sum.momentum.x += more.momentum.x;
  sum.momentum.y += more.momentum.y;
  sum.square += more.square;
}

/// What a boundary did to a node's velocity, which was `free`, goes into its change over the step too, and into the motion of all.
template <class Real>
static void add_to_change(NodesOf<Real>& nodes, NodeMotion& motion, std::size_t node, Vec2 free) {
  const NodeVelocity<Real> velocity = pair_in(nodes.motion, velocity_of(node));
  const NodeVelocity<Real> change = pair_in(nodes.motion, change_of(node));
  const Vec2 by_boundary = {velocity.x - free.x, velocity.y - free.y};
  change.x += static_cast<Real>(by_boundary.x);
  change.y += static_cast<Real>(by_boundary.y);
  const double mass = nodes.mass[node];
  motion.momentum.x += mass * by_boundary.x;
  motion.momentum.y += mass * by_boundary.y;
  motion.square += mass * (by_boundary.x * (velocity.x + free.x) + by_boundary.y * (velocity.y + free.y));
}

static double along(Vec2 tangent, Vec2 v) { return tangent.x * v.x + tangent.y * v.y; }

/// Whether a node lies on the base itself: those below do not keep what a two-body base gives them (update_new_velocities).
template <class Real>
static bool is_on_base(const NodesOf<Real>& nodes, std::size_t node) {
  return node % static_cast<std::size_t>(nodes.storage.rows) == NodeStorage::padding;
}

/// Remembers what the base did to a node whose velocity would have been `free`; before add_to_change.
template <class Real>
static void remember_friction(NodesOf<Real>& nodes, std::size_t node, Vec2 free, Vec2 tangent, const NodeSettings& settings, Vec2 gravity) {
  const Vec2 now = pair_at(nodes.motion, velocity_of(node));
  const double would_be = along(tangent, free);
  const double change = along(tangent, pair_at(nodes.motion, change_of(node)));
  const double fall = settings.step * along(tangent, gravity);
  const double mass = nodes.mass[node];
  nodes.frictions.push_back({.node = node,
                             .push = {mass * (now.x - free.x), mass * (now.y - free.y)},
                             .slip = now.x,
                             .tangent = tangent,
                             .force = mass * (change - fall),
                             .before = would_be - change,
                             .after = would_be - change,
                             .is_held = would_be != 0 && along(tangent, now) == 0 && is_on_base(nodes, node)});
}

/// Base contact with friction.
template <class Real>
static void touch_base(NodesOf<Real>& nodes, NodeMotion& motion, const NodeBox& box, const NodeSettings& settings, Vec2 gravity) {
  for_nodes_on_base(nodes, box, [&](std::size_t node) {
    const NodeVelocity<Real> velocity = pair_in(nodes.motion, velocity_of(node));
    const Vec2 free = {velocity.x, velocity.y};
    hold_at_base(velocity, settings.boundaries.base);
    if (settings.boundaries.base != BaseContact::stick)
      velocity.x = static_cast<Real>(rubbed(free.x, std::max(0.0, -free.y), settings.boundaries.base_friction));
    remember_friction(nodes, node, free, {1, 0}, settings, gravity);
    add_to_change(nodes, motion, node, free);
  });
}

/// Two-body contact at one row of nodes: where soil approaches the base along the normal, that part of its velocity is taken
/// away, and friction acts on the rest.
template <class Real>
static void touch_body(NodesOf<Real>& nodes, NodeMotion& motion, const NodeBox& box, int row, const std::vector<Vec2>& normals,
                       const NodeSettings& settings, Vec2 gravity) {
  if (row < box.first_row || row >= box.last_row) return;
  for (int column = box.first_column; column < box.last_column; ++column) {
    const std::size_t node = nodes.storage.index(column, row);
    const NodeVelocity<Real> velocity = pair_in(nodes.motion, velocity_of(node));
    const Vec2 free = {velocity.x, velocity.y};
    const Vec2 normal = normals[static_cast<std::size_t>(column)];
    const double approach = free.x * normal.x + free.y * normal.y;
    if (approach <= 0) continue;
    const Vec2 tangent = {-normal.y, normal.x};
    const double left = rubbed(along(tangent, free), approach, settings.boundaries.base_friction);
    velocity.x = static_cast<Real>(left * tangent.x);
    velocity.y = static_cast<Real>(left * tangent.y);
    remember_friction(nodes, node, free, tangent, settings, gravity);
    add_to_change(nodes, motion, node, free);
  }
}

template <class Real>
static void touch_walls(NodesOf<Real>& nodes, NodeMotion& motion, const NodeBox& box, const NodeSettings& settings) {
  const auto touch = [&](Wall wall) {
    return [&nodes, &motion, wall](std::size_t node) {
      const NodeVelocity<Real> velocity = pair_in(nodes.motion, velocity_of(node));
      const Vec2 free = {velocity.x, velocity.y};
      hold_at_wall(velocity, wall);
      add_to_change(nodes, motion, node, free);
    };
  };
  for_nodes_left(nodes, box, touch(settings.boundaries.left));
  for_nodes_right(nodes, box, settings.grid, touch(settings.boundaries.right));
}

template <class Real>
void fold_mass(NodesOf<Real>& nodes, const NodeBox& box, const NodeSettings& settings) {
  const auto end = [&](int column) -> int& { return nodes.ends[static_cast<std::size_t>(column)]; };
  for (const int wall : {NodeStorage::padding, settings.grid.cells_x + NodeStorage::padding})  // what is folded reaches as far
    end(wall - 1) = end(wall + 1) = std::max(end(wall - 1), end(wall + 1));
  for_each_image(nodes, box, settings, [&](std::size_t behind, std::size_t before, Mirror) {
    nodes.sums[mass_of(before)] += nodes.sums[mass_of(behind)];
    nodes.sums[mass_of(behind)] = 0;
  });
}

template <class Real>
void update_velocities(NodesOf<Real>& nodes, NodeEnergies& energies, const NodeBox& box, Vec2 gravity, const NodeSettings& settings,
                       const ContactNormals& contact) {
  for_each_image(nodes, box, settings, [&](std::size_t behind, std::size_t before, Mirror mirror) {
    fold_pairs(nodes.sums, momentum_of(behind), momentum_of(before), mirror);
    fold_pairs(nodes.force, force_of(behind), force_of(before), mirror);
  });
  for_each_column(nodes, box, [&](std::size_t first, std::size_t count) {  // all at once, while the numbers are in the nearest cache
    keep_mass(nodes.sums.data() + 4 * first, nodes.mass.data() + first, count);
    balance_momentum(nodes.sums.data() + 4 * first, nodes.force.data() + 2 * first, nodes.motion.data() + 4 * first, count,
                     static_cast<Real>(gravity.x), static_cast<Real>(gravity.y), static_cast<Real>(settings.least_mass),
                     static_cast<Real>(settings.step));
    add(energies.unhindered, motion_of(nodes.mass.data() + first, nodes.motion.data() + 4 * first, count));
    clear(nodes.sums, 4 * first, 4 * count);
    clear(nodes.force, 2 * first, 2 * count);
    clear(nodes.new_velocity, 2 * first, 2 * count);
  });
  touch_walls(nodes, energies.by_walls, box, settings);
  if (settings.boundaries.base == BaseContact::two_body) {
    touch_body(nodes, energies.by_base, box, NodeStorage::padding, contact.top, settings, gravity);
    touch_body(nodes, energies.by_base, box, NodeStorage::padding - 1, contact.below, settings, gravity);
  } else {
    touch_base(nodes, energies.by_base, box, settings, gravity);
  }
  for_each_image(nodes, box, settings, [&](std::size_t behind, std::size_t before, Mirror mirror) {
    reflect_pairs(nodes.motion, change_of(behind), change_of(before), mirror);
    reflect_pairs(nodes.motion, velocity_of(behind), velocity_of(before), mirror);
  });
}

double NodeEnergies::gravity_work(Vec2 gravity, double step) const {
  const double x = unhindered.momentum.x + by_walls.momentum.x + by_base.momentum.x;
  const double y = unhindered.momentum.y + by_walls.momentum.y + by_base.momentum.y;
  return step * (gravity.x * x + gravity.y * y);
}

double NodeEnergies::kinetic() const { return 0.5 * (unhindered.square + by_walls.square + by_base.square); }

template <class Real>
void copy_velocities(NodesOf<Real>& nodes, const NodeBox& box) {
  for_each_column(nodes, box, [&](std::size_t first, std::size_t count) {
    for (std::size_t node = first; node < first + count; ++node)
      std::copy_n(&nodes.motion[velocity_of(node)], 2, &nodes.new_velocity[new_velocity_of(node)]);
  });
}

template <class Real>
void copy_momenta(NodesOf<Real>& nodes, const NodeBox& box) {
  for_each_column(nodes, box, [&](std::size_t first, std::size_t count) {
    keep_mass(nodes.sums.data() + 4 * first, nodes.mass.data() + first, count);
    for (std::size_t node = first; node < first + count; ++node) {
      std::copy_n(&nodes.sums[momentum_of(node)], 2, &nodes.new_velocity[new_velocity_of(node)]);
      std::copy_n(&nodes.sums[momentum_of(node)], 2, &nodes.motion[velocity_of(node)]);  // what friction held in the last step is free
    }
  });
}

template <class Real>
void update_new_velocities(NodesOf<Real>& nodes, const NodeBox& box, const NodeSettings& settings) {
  for_each_image(nodes, box, settings, [&](std::size_t behind, std::size_t before, Mirror mirror) {
    fold_pairs(nodes.new_velocity, new_velocity_of(behind), new_velocity_of(before), mirror);
  });
  for_each_column(nodes, box, [&](std::size_t first, std::size_t count) {
    divide_by_mass(nodes.mass.data() + first, nodes.new_velocity.data() + 2 * first, count, static_cast<Real>(settings.least_mass));
  });
  const std::size_t first = nodes.storage.index(box.first_column, 0);
  const std::size_t last = nodes.storage.index(box.last_column, 0);
  for (NodeFriction& friction : nodes.frictions)
    if (first <= friction.node && friction.node < last)
      friction.after = along(friction.tangent, pair_at(nodes.new_velocity, new_velocity_of(friction.node)));
  const auto hold = [&](Wall wall) {
    return [&nodes, wall](std::size_t node) { hold_at_wall(pair_in(nodes.new_velocity, new_velocity_of(node)), wall); };
  };
  for_nodes_left(nodes, box, hold(settings.boundaries.left));
  for_nodes_right(nodes, box, settings.grid, hold(settings.boundaries.right));
  for_nodes_on_base(nodes, box, [&](std::size_t node) {
    const NodeVelocity<Real> velocity = pair_in(nodes.new_velocity, new_velocity_of(node));
    hold_at_base(velocity, settings.boundaries.base);
    const bool is_held_by_friction = nodes.motion[velocity_of(node)] == 0;
    if (is_held_by_friction) velocity.x = 0;
  });
  for_each_image(nodes, box, settings, [&](std::size_t behind, std::size_t before, Mirror mirror) {
    reflect_pairs(nodes.new_velocity, new_velocity_of(behind), new_velocity_of(before), mirror);
  });
}

double friction_work(const NodeFriction& friction) {
  const double impulse = along(friction.tangent, friction.push);
  const double held_back = friction.is_held ? friction.force * friction.after : 0;
  return -0.5 * impulse * (friction.before + friction.after) - held_back;
}

// ---- for both precisions ------------------------------------------------------------------------------------------------

template struct NodesOf<double>;
template struct NodesOf<float>;
template void begin_step(NodesOf<double>&, const NodeBox&);
template void begin_step(NodesOf<float>&, const NodeBox&);
template std::vector<double> new_velocities_in(const NodesOf<double>&, const NodeBox&);
template std::vector<double> new_velocities_in(const NodesOf<float>&, const NodeBox&);
template void set_new_velocities(NodesOf<double>&, const NodeBox&, const std::vector<double>&);
template void set_new_velocities(NodesOf<float>&, const NodeBox&, const std::vector<double>&);
template void fold_mass(NodesOf<double>&, const NodeBox&, const NodeSettings&);
template void fold_mass(NodesOf<float>&, const NodeBox&, const NodeSettings&);
template void update_velocities(NodesOf<double>&, NodeEnergies&, const NodeBox&, Vec2, const NodeSettings&, const ContactNormals&);
template void update_velocities(NodesOf<float>&, NodeEnergies&, const NodeBox&, Vec2, const NodeSettings&, const ContactNormals&);
template void copy_velocities(NodesOf<double>&, const NodeBox&);
template void copy_velocities(NodesOf<float>&, const NodeBox&);
template void copy_momenta(NodesOf<double>&, const NodeBox&);
template void copy_momenta(NodesOf<float>&, const NodeBox&);
template void update_new_velocities(NodesOf<double>&, const NodeBox&, const NodeSettings&);
template void update_new_velocities(NodesOf<float>&, const NodeBox&, const NodeSettings&);

}  // namespace slidezone
