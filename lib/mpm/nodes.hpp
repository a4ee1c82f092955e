// The nodes of the background grid during a step, and what happens on them between the two sweeps: momentum balance,
// boundaries and base contact.
//
// Numbers lie node after node in the order of grid/node_storage.hpp; those that a point needs at the same time lie side by side.
#pragma once

#include <vector>

#include "core/vec2.hpp"
#include "core/zeroed_allocator.hpp"
#include "grid/node_storage.hpp"
#include "mpm/settings.hpp"

namespace slidezone {

/// What the base did to a node in the step.
struct NodeFriction {
  std::size_t node;
  Vec2 push;      // impulse of the base on the soil, friction included, N s/m
  double slip;    // m/s, of the node along x, the base, afterwards
  Vec2 tangent;   // direction of friction; what follows is along it
  double force;   // internal force times the step, N s/m
  double before;  // m/s, of the points on the node before the step
  double after;   // m/s, of the points after it: new_velocity before walls and base hold it. USL and USF do not know; there: before
  bool is_held;   // friction keeps the node where it is
};

/// Numbers of all nodes of the grid; those that no point has reached take no memory.
template <class Real>
using NodeNumbers = std::vector<Real, ZeroedAllocator<Real>>;

template <class Real>
struct NodesOf {
  explicit NodesOf(NodeStorage where);

  NodeStorage storage;
  // Sums over points, which sweep A adds to and update_velocities clears: between steps they are 0.
  NodeNumbers<Real> sums;   // four a node: momentum (x, y), kg/s; mass, kg/m; nothing
  NodeNumbers<Real> force;  // pairs (x, y): internal force, N/m

  NodeNumbers<Real> mass;          // kg/m
  NodeNumbers<Real> motion;        // four a node: change of velocity over the step (x, y), and velocity after it, m/s
  NodeNumbers<Real> new_velocity;  // pairs (x, y), m/s, of the moved points; summed as their momentum
  std::vector<int> ends;           // by column: the row after those that points have reached in this step; sums beyond are 0
  std::vector<NodeFriction> frictions;
};

/// Sums over nodes: momentum, kg/s, and twice the kinetic energy, J/m.
struct NodeMotion {
  Vec2 momentum{};
  double square = 0;
};

/// The motion of all nodes in one step. Each of its parts is summed up from left to right: they have the same bits however many boxes the
/// nodes come in.
struct NodeEnergies {
  NodeMotion unhindered;         // as forces leave it
  NodeMotion by_walls, by_base;  // what boundaries did to it

  /// J/m.
  double gravity_work(Vec2 gravity, double step) const;
  double kinetic() const;
};

/// Nodes lighter than this part of a point's mass carry no velocity: the quotients there are noise.
template <class Real>
constexpr double least_mass_fraction = 1e-9;
template <>
inline constexpr double least_mass_fraction<float> = 1e-7;  // sums of floats are good to 1e-7

/// What the node updates need beside the nodes.
struct NodeSettings {
  GridShape grid;
  Boundaries boundaries;
  double least_mass = 0;  // kg/m
  double step = 0;        // s
};

/// Normals of a two-body base at the nodes of its top row and of the row below; see contact.hpp. Empty for other bases.
struct ContactNormals {
  std::vector<Vec2> top;  // by column, NodeStorage counting; out of the soil, of length 1, or 0 where the soil does not reach
  std::vector<Vec2> below;
};

/// Begins a step: points have reached no node of the box yet.
template <class Real>
void begin_step(NodesOf<Real>& nodes, const NodeBox& box);

/// The new velocities of the nodes in the box, column by column, and back.
template <class Real>
std::vector<double> new_velocities_in(const NodesOf<Real>& nodes, const NodeBox& box);
template <class Real>
void set_new_velocities(NodesOf<Real>& nodes, const NodeBox& box, const std::vector<double>& velocities);

/// Walls and base are mirrors: what points map to the padding nodes behind one is folded onto the nodes in front, with the
/// normal component turned round, and the padding nodes move as mirror images. Without this a point whose domain
/// reaches through the base would still be carried by the first node above it, and would sink through.
/// A two-body base is no mirror.
template <class Real>
void fold_mass(NodesOf<Real>& nodes, const NodeBox& box, const NodeSettings& settings);

/// motion: velocity = momentum / mass + change with change = dt (force / mass + gravity), then boundaries: a velocity that a wall
/// or the base forbids is taken away, and the base takes the friction impulse, at most mu times the normal impulse
/// max(0, -m v_y) of the unhindered motion (Coulomb; once per step). Keeps the masses, and clears the sums: those of sweep A for the next
/// step, new_velocity for those of sweep B. Adds to `energies` and to nodes.frictions, which are to be empty when a step begins: the nodes
/// of a step may come a box at a time. A two-body base acts on the nodes that `contact` names, along its normals.
/// After fold_mass.
template <class Real>
void update_velocities(NodesOf<Real>& nodes, NodeEnergies& energies, const NodeBox& box, Vec2 gravity, const NodeSettings& settings,
                       const ContactNormals& contact);

/// new_velocity = the velocities that moved the points.
template <class Real>
void copy_velocities(NodesOf<Real>& nodes, const NodeBox& box);

/// new_velocity = the momenta of the points before forces act, for update_new_velocities (USF), which needs the masses too.
template <class Real>
void copy_momenta(NodesOf<Real>& nodes, const NodeBox& box);

/// new_velocity = momentum / mass, without what walls and base forbid. Friction acted in update_velocities already, and so did
/// all of a two-body base; what friction stopped there stays stopped: else the soil would be strained by a slip that does not
/// happen, and stiff soil at rest on a rough base would begin to shake. After update_velocities or copy_momenta.
template <class Real>
void update_new_velocities(NodesOf<Real>& nodes, const NodeBox& box, const NodeSettings& settings);

/// What friction took from the soil at a node in the step, J/m; after update_new_velocities. An impulse J on a node changes the kinetic
/// energy of the points by J (before + after) / 2 exactly, with the velocities that points have on the node; and where friction holds a
/// node that they would move, the internal force f does less work, by f dt after. The velocity of the node itself will not do for
/// either: it is 0 where points above a held node slide on.
double friction_work(const NodeFriction& friction);

}  // namespace slidezone
