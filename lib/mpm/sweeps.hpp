// The two sweeps over material points of one MUSL step (modified update stress last; Sulsky, Zhou and Schreyer 1995), fused
// so that little passes between them: a point's movement, and where it lies in its cell.
//
//   sweep A   velocity gradient from the last step's node velocities, stress (Jaumann rate, Drucker-Prager), move;
//             then mass, momentum and internal force to the nodes
//   (nodes)   momentum and force -> velocity and its change: nodes.hpp
//   sweep B   velocity change and movement from the nodes; then the new momentum to the nodes
//   (nodes)   new momentum -> node velocities, for the next sweep A
//
// Compiled once for each instruction set from one source and chosen when the run starts. Raw pointers because the sweeps may
// share no inline function with code compiled for another instruction set.
#pragma once

#include <cstddef>

#include "grid/node_storage.hpp"
#include "soil/drucker_prager.hpp"

namespace slidezone {

/// What averaging over cells needs; see block_dilation.hpp. Cells are counted by their lower left node.
template <class Real>
struct Dilation {
  Real *xx, *xy, *yx, *yy;                // velocity gradient of each point, 1/s
  int* cell;                              // of each point
  Real *cell_volume, *cell_dilation;      // sums over the points of a cell: V, V (L_xx + L_yy)
  Real *cell_now_volume, *cell_pressure;  // sums after the move: V, V (s_xx + s_yy) / 2
};

/// What the sweeps read and write; arrays as in points.hpp and nodes.hpp, whose layout grid/node_storage.hpp gives.
template <class Real>
struct SweepData {
  // points
  std::size_t point_count;
  double *x, *y;
  Real *velocity, *movement;
  Real *xx, *yy, *zz, *xy, *volume, *plastic_strain;
  const Real* softening_strain;  // what softening follows: plastic_strain itself, or its average over neighbours
  const Real *mass, *peak_cohesion;
  const int* soil;
  const SoilConstantsOf<Real>* soils;
  Real *s_x, *s_y;  // where points lie in their cells (grid/gimp.hpp), and the first nodes that they reach: written whenever they move
  int* first_node;
  // nodes
  Real *node_sums, *node_force;   // written by sweep A
  const Real* node_motion;        // read by sweep B
  Real* node_new_momentum;        // written by sweep B
  const Real* node_new_velocity;  // read by the next sweep A
  int* column_ends;               // by column, the row after those that points reach; grows whenever points are placed
  Dilation<Real>* dilation;       // for AntiLocking::b_bar alone
  NodeStorage storage;
  NodeBox box;  // the nodes that points may reach; they are zeroed before sweep A
  // geometry
  GridShape grid;
  double half_size_x, half_size_y;  // of a point's domain, in cells; 0 for linear shape functions
  double step;                      // s
  double grid_part;                 // of a point's velocity that is taken from the grid in each step: damping
  bool fetches_ahead;               // points lie in the main memory: sweep A is to ask for a block's numbers while it is at the last one's
};

/// What sweep A saw, over all points.
struct SweepReport {
  double internal_work = 0;  // J/m: stress times strain increment times volume
  NodeBox box;               // the nodes that points reach now
  int out_of_order = 0;      // points whose first node comes before that of their predecessor, in the same block
  bool is_broken = false;    // some point lies outside data.box, has no positive volume, or is not finite
};

enum class InstructionSet {  // from the least on
  baseline,
  avx2,
  avx512_in_halves,  // for processors that compute with one half of a register after the other: Zen 4
  avx512
};

/// The best that this processor has.
InstructionSet best_instruction_set();

/// The sweeps for one instruction set and one combination of soil traits.
template <class Real>
struct Sweeps {
  SweepReport (*place)(const SweepData<Real>&);  // finds where points lie, which all others but it take for known
  // MUSL and USL
  SweepReport (*update_and_map)(const SweepData<Real>&);  // sweep A
  SweepReport (*update)(const SweepData<Real>&);          // sweep A without the map to the nodes: ends a run
  // the same with averages over cells, in three passes
  void (*gather_dilation)(const SweepData<Real>&);
  SweepReport (*update_with_mean_dilation)(const SweepData<Real>&);
  void (*map_with_mean_stress)(const SweepData<Real>&);
  // USF
  SweepReport (*move_and_map_momentum)(const SweepData<Real>&);
  SweepReport (*update_and_map_force)(const SweepData<Real>&);
  // sweep B, with the second map of MUSL and without; both give the energy that damping took, J/m
  double (*gather_and_map)(const SweepData<Real>&);
  double (*gather)(const SweepData<Real>&);
};

template <class Real>
Sweeps<Real> sweeps(InstructionSet set, SoilTraits traits);
template <>
Sweeps<double> sweeps(InstructionSet set, SoilTraits traits);
template <>
Sweeps<float> sweeps(InstructionSet set, SoilTraits traits);

}  // namespace slidezone
