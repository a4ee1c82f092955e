// Compiled three times, with SLIDEZONE_SWEEPS naming the function for each instruction set; see CMakeLists.txt.
#include "mpm/sweeps.hpp"

#include "grid/gimp.hpp"
#include "mpm/row.hpp"

namespace slidezone {
namespace {

constexpr int block_size = 64;  // points a block: its arrays stay in the first-level cache

/// Points first, first + 1, ... of one block.
struct Block {
  std::size_t first;
  int count;
};

/// Shape functions of a block's points, struct of arrays.
struct BlockWeights {
  double s_x[block_size], q_x[block_size], r_x[block_size];
  double s_y[block_size], q_y[block_size], r_y[block_size];
  int base[block_size];  // index of the first node that the point reaches
};

/// Velocity gradients of a block's points, 1/s: xy is the derivative of v_x along y.
struct BlockGradients {
  double xx[block_size], xy[block_size], yx[block_size], yy[block_size];
};

// ---- shape functions ----------------------------------------------------------------------------------------------------

// A row's weights N = {1 - s + q, s - 2 q, q} and slopes {r - 1, 1 - 2 r, r}, each for both components, the fourth node zero.
alignas(64) constexpr double value_1[8] = {1, 1, 0, 0, 0, 0, 0, 0};
alignas(64) constexpr double value_s[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
alignas(64) constexpr double value_q[8] = {1, 1, -2, -2, 1, 1, 0, 0};
alignas(64) constexpr double slope_1[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
alignas(64) constexpr double mass_1[4] = {1, 0, 0, 0};
alignas(64) constexpr double mass_s[4] = {-1, 1, 0, 0};
alignas(64) constexpr double mass_q[4] = {1, -2, 1, 0};

[[gnu::always_inline]] inline Row row_values(double s, double q) {
  return Row::load(value_1) + s * Row::load(value_s) + q * Row::load(value_q);
}
[[gnu::always_inline]] inline Row row_slopes(double r) { return Row::load(slope_1) + r * Row::load(value_q); }
[[gnu::always_inline]] inline MassRow mass_values(double s, double q) {
  return MassRow::load(mass_1) + s * MassRow::load(mass_s) + q * MassRow::load(mass_q);
}

double inverse_4l(double half_size) { return half_size > 0 ? 1 / (4 * half_size) : 0; }

/// One axis along which a block's points lie.
struct Axis {
  double inverse_cell;
  double half_size;  // of a point's domain, in cells
  int low, high;     // first nodes that the box allows, in NodeStorage counting
};

/// First nodes of a block's points along one axis.
struct FirstNodes {
  int node[block_size];
  int low, high;  // the least and the greatest of them
  bool is_lost;   // some point reaches beyond the box, or is not finite; its first node is kept within the box all the same
};

[[gnu::always_inline]] inline FirstNodes weigh_axis(const double* position, int count, Axis axis, double* s, double* q, double* r) {
  if (count < 1) __builtin_unreachable();  // blocks are never empty
  FirstNodes first;
  const double half_size = axis.half_size;
  const double over_4l = inverse_4l(half_size);
  const double low = axis.low;
  const double high = axis.high;
  long lost = 0;  // as wide as a double, so that both fill the same vector
#pragma GCC ivdep
  for (int p = 0; p < count; ++p) {
    const double in_cells = position[p] * axis.inverse_cell;
    const double place = in_cells - half_size + NodeStorage::padding;
    const double at_least = place > low ? place : low;
    const int node = static_cast<int>(at_least < high ? at_least : high);
    const AxisWeights weights = axis_weights(in_cells, node - NodeStorage::padding, half_size, over_4l);
    first.node[p] = node;
    s[p] = weights.s;
    q[p] = weights.q;
    r[p] = weights.r;
    lost |= place >= low && place < high + 1 ? 0L : 1L;
  }
  first.low = axis.high;
  first.high = axis.low;
  for (int p = 0; p < count; ++p) {
    first.low = first.node[p] < first.low ? first.node[p] : first.low;
    first.high = first.node[p] > first.high ? first.node[p] : first.high;
  }
  first.is_lost = lost != 0;
  return first;
}

/// The nodes that a block's points reach, beside their weights.
struct Reached {
  NodeBox box;
  bool is_lost;
};

[[gnu::always_inline]] inline Reached weigh(const SweepData& data, Block block, BlockWeights& weights) {
  constexpr int reach = 3;  // nodes along each axis
  const FirstNodes in_x = weigh_axis(data.x + block.first, block.count,
                                     {1 / data.grid.cell_x, data.half_size_x, data.box.first_column, data.box.last_column - reach},
                                     weights.s_x, weights.q_x, weights.r_x);
  const FirstNodes in_y =
      weigh_axis(data.y + block.first, block.count, {1 / data.grid.cell_y, data.half_size_y, data.box.first_row, data.box.last_row - reach},
                 weights.s_y, weights.q_y, weights.r_y);
  for (int p = 0; p < block.count; ++p) weights.base[p] = in_x.node[p] * data.storage.rows + in_y.node[p];
  return {{in_x.low, in_x.high + reach, in_y.low, in_y.high + reach}, in_x.is_lost || in_y.is_lost};
}

// ---- from nodes to points -------------------------------------------------------------------------------------------------

/// The rows of node values, one pair a node, that a point reaches.
struct Stencil {
  Row column[3];
};

[[gnu::always_inline]] inline Stencil stencil(const double* node_pairs, int base, std::size_t rows) {
  const double* from = node_pairs + 2 * static_cast<std::size_t>(base);
  return {{Row::load(from), Row::load(from + 2 * rows), Row::load(from + 4 * rows)}};
}

[[gnu::always_inline]] inline Row combined(const Stencil& values, const AxisValues& weights) {
  return weights.node[0] * values.column[0] + weights.node[1] * values.column[1] + weights.node[2] * values.column[2];
}

[[gnu::always_inline]] inline void gather_gradients(const SweepData& data, Block block, const BlockWeights& weights,
                                                    BlockGradients& gradients) {
  const double inverse_x = 1 / data.grid.cell_x;
  const double inverse_y = 1 / data.grid.cell_y;
  const double* node_velocity = data.node_new_velocity;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  for (int p = 0; p < block.count; ++p) {
    const AxisWeights in_x{weights.s_x[p], weights.q_x[p], weights.r_x[p]};
    const Stencil velocity = stencil(node_velocity, weights.base[p], rows);
    const Pair along_x = sum_over_nodes(combined(velocity, shape_slopes(in_x)) * row_values(weights.s_y[p], weights.q_y[p]));
    const Pair along_y = sum_over_nodes(combined(velocity, shape_values(in_x)) * row_slopes(weights.r_y[p]));
    gradients.xx[p] = along_x.x * inverse_x;
    gradients.yx[p] = along_x.y * inverse_x;
    gradients.xy[p] = along_y.x * inverse_y;
    gradients.yy[p] = along_y.y * inverse_y;
  }
}

// ---- stress and movement ----------------------------------------------------------------------------------------------------

struct Increment {
  double xx, yy, xy;  // strain increments; xy is half the engineering shear
  double spin;        // increment of rotation, (dv_x/dy - dv_y/dx) dt / 2
};

/// Jaumann rate and elastic trial stress.
[[gnu::always_inline]] inline Stress trial_stress(Stress old, Increment strain, double K, double G) {
  const double volumetric = strain.xx + strain.yy;
  const double lambda = K - 2.0 / 3.0 * G;
  return {old.xx + lambda * volumetric + 2 * G * strain.xx + 2 * strain.spin * old.xy,
          old.yy + lambda * volumetric + 2 * G * strain.yy - 2 * strain.spin * old.xy, old.zz + lambda * volumetric,
          old.xy + 2 * G * strain.xy + strain.spin * (old.yy - old.xx)};
}

struct StressUpdate {
  double internal_work;
  bool is_broken;
};

/// The soil of point p; without layers the same for all, so that its constants stay in registers.
template <SoilTraits traits>
[[gnu::always_inline]] inline const SoilConstants& soil_of_point(const SoilConstants* soils, const int* soil_of, int p) {
  return traits.has_layers ? soils[soil_of[p]] : soils[0];
}

[[gnu::always_inline]] inline double block_sum(const double (&values)[block_size]) {
  Row sums{};
  for (int p = 0; p < block_size; p += 8) sums = sums + Row::load(values + p);
  double lane[8];
  sums.store(lane);
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

template <SoilTraits traits>
[[gnu::always_inline]] inline StressUpdate update_stress(const SweepData& data, Block block, const BlockGradients& gradients) {
  double* xx = data.xx + block.first;
  double* yy = data.yy + block.first;
  double* zz = data.zz + block.first;
  double* xy = data.xy + block.first;
  double* volume = data.volume + block.first;
  double* plastic_strain = data.plastic_strain + block.first;
  const double* peak_cohesion = data.peak_cohesion + block.first;
  const int* soil_of = data.soil + block.first;
  const SoilConstants* soils = data.soils;
  const double step = data.step;
  double work[block_size] = {};  // summed below: a sum inside the loop would keep it from becoming vector instructions
  long broken = 0;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    const SoilConstants& soil = soil_of_point<traits>(soils, soil_of, p);
    const Increment strain{gradients.xx[p] * step, gradients.yy[p] * step, 0.5 * (gradients.xy[p] + gradients.yx[p]) * step,
                           0.5 * (gradients.xy[p] - gradients.yx[p]) * step};
    const Stress old{xx[p], yy[p], zz[p], xy[p]};
    Stress now = trial_stress(old, strain, soil.bulk, soil.shear);
    const YieldSurface yield = yield_surface<traits>(soil, peak_cohesion[p], plastic_strain[p]);
    plastic_strain[p] += return_to_yield<traits>(now, soil, yield);
    work[p] = volume[p] * 0.5 * ((old.xx + now.xx) * strain.xx + (old.yy + now.yy) * strain.yy + 2 * (old.xy + now.xy) * strain.xy);
    volume[p] *= 1 + strain.xx + strain.yy;
    broken |= volume[p] > 0 ? 0L : 1L;
    xx[p] = now.xx;
    yy[p] = now.yy;
    zz[p] = now.zz;
    xy[p] = now.xy;
  }
  return {block_sum(work), broken != 0};
}

[[gnu::always_inline]] inline void move(const SweepData& data, Block block) {
  double* x = data.x + block.first;
  double* y = data.y + block.first;
  const double* movement = data.movement + 2 * block.first;
#pragma GCC ivdep
  for (int p = 0; p < block.count; ++p) {
    x[p] += movement[2 * p];
    y[p] += movement[2 * p + 1];
  }
}

// ---- from points to nodes -------------------------------------------------------------------------------------------------

/// Sums for the nodes of one base while consecutive points share it; flushed to the nodes when the base changes. Right for
/// any order of points, fast when they are nearly sorted by cell.
template <class NodeRow, int lanes_a_node>
struct Accumulator {
  NodeRow column_0{};
  NodeRow column_1{};
  NodeRow column_2{};

  [[gnu::always_inline]] void add(const AxisValues& weights, NodeRow values) {
    column_0 = column_0 + weights.node[0] * values;
    column_1 = column_1 + weights.node[1] * values;
    column_2 = column_2 + weights.node[2] * values;
  }
  [[gnu::always_inline]] void flush(double* nodes, int base, std::size_t rows) {
    double* to = nodes + lanes_a_node * static_cast<std::size_t>(base);
    const std::size_t next = lanes_a_node * rows;
    (NodeRow::load(to) + column_0).store(to);
    (NodeRow::load(to + next) + column_1).store(to + next);
    (NodeRow::load(to + 2 * next) + column_2).store(to + 2 * next);
    *this = {};
  }
};
using PairAccumulator = Accumulator<Row, 2>;
using MassAccumulator = Accumulator<MassRow, 1>;

/// Mass, momentum m v and internal force -V stress . grad N to the nodes.
[[gnu::always_inline]] inline void map_to_nodes(const SweepData& data, Block block, const BlockWeights& weights) {
  const double inverse_x = 1 / data.grid.cell_x;
  const double inverse_y = 1 / data.grid.cell_y;
  const double* velocity = data.velocity + 2 * block.first;
  const double* xx = data.xx + block.first;
  const double* yy = data.yy + block.first;
  const double* xy = data.xy + block.first;
  const double* volume = data.volume + block.first;
  const double* mass = data.mass + block.first;
  double* node_momentum = data.node_momentum;
  double* node_force = data.node_force;
  double* node_mass = data.node_mass;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  PairAccumulator momentum_sums, force_sums;
  MassAccumulator mass_sums;
  int base = weights.base[0];
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      momentum_sums.flush(node_momentum, base, rows);
      force_sums.flush(node_force, base, rows);
      mass_sums.flush(node_mass, base, rows);
      base = weights.base[p];
    }
    const AxisWeights in_x{weights.s_x[p], weights.q_x[p], weights.r_x[p]};
    const AxisValues values_x = shape_values(in_x);
    const Row values_y = row_values(weights.s_y[p], weights.q_y[p]);
    const double force_x = -volume[p] * inverse_x;
    const double force_y = -volume[p] * inverse_y;
    momentum_sums.add(values_x, values_y * pairs(mass[p] * velocity[2 * p], mass[p] * velocity[2 * p + 1]));
    force_sums.add(shape_slopes(in_x), values_y * pairs(force_x * xx[p], force_x * xy[p]));
    force_sums.add(values_x, row_slopes(weights.r_y[p]) * pairs(force_y * xy[p], force_y * yy[p]));
    mass_sums.add(values_x, mass[p] * mass_values(weights.s_y[p], weights.q_y[p]));
  }
  momentum_sums.flush(node_momentum, base, rows);
  force_sums.flush(node_force, base, rows);
  mass_sums.flush(node_mass, base, rows);
}

/// v += sum N dv, movement = dt sum N v, new momentum sum N m v.
[[gnu::always_inline]] inline void gather_and_map_block(const SweepData& data, Block block, const BlockWeights& weights) {
  double* velocity = data.velocity + 2 * block.first;
  double* movement = data.movement + 2 * block.first;
  const double* mass = data.mass + block.first;
  const double* node_velocity = data.node_velocity;
  const double* node_change = data.node_change;
  double* node_new_momentum = data.node_new_momentum;
  const auto rows = static_cast<std::size_t>(data.storage.rows);
  const double step = data.step;
  PairAccumulator momentum_sums;
  int base = weights.base[0];
  for (int p = 0; p < block.count; ++p) {
    if (weights.base[p] != base) {
      momentum_sums.flush(node_new_momentum, base, rows);
      base = weights.base[p];
    }
    const AxisValues values_x = shape_values({weights.s_x[p], weights.q_x[p], weights.r_x[p]});
    const Row values_y = row_values(weights.s_y[p], weights.q_y[p]);
    const Pair change = sum_over_nodes(combined(stencil(node_change, base, rows), values_x) * values_y);
    const Pair moving = sum_over_nodes(combined(stencil(node_velocity, base, rows), values_x) * values_y);
    const double velocity_x = velocity[2 * p] + change.x;
    const double velocity_y = velocity[2 * p + 1] + change.y;
    velocity[2 * p] = velocity_x;
    velocity[2 * p + 1] = velocity_y;
    movement[2 * p] = step * moving.x;
    movement[2 * p + 1] = step * moving.y;
    momentum_sums.add(values_x, values_y * pairs(mass[p] * velocity_x, mass[p] * velocity_y));
  }
  momentum_sums.flush(node_new_momentum, base, rows);
}

// ---- the sweeps -------------------------------------------------------------------------------------------------------------

enum class Map { yes, no };

template <class Act>
[[gnu::always_inline]] inline void for_each_block(const SweepData& data, Act act) {
  for (std::size_t first = 0; first < data.point_count; first += block_size) {
    const std::size_t left = data.point_count - first;
    act(Block{first, left < block_size ? static_cast<int>(left) : block_size});
  }
}

NodeBox joined(const NodeBox& a, const NodeBox& b) {
  return {a.first_column < b.first_column ? a.first_column : b.first_column, a.last_column > b.last_column ? a.last_column : b.last_column,
          a.first_row < b.first_row ? a.first_row : b.first_row, a.last_row > b.last_row ? a.last_row : b.last_row};
}

template <SoilTraits traits, Map map>
SweepReport sweep_a(const SweepData& data) {
  SweepReport report;
  report.box = {data.storage.columns, 0, data.storage.rows, 0};
  for_each_block(data, [&](Block block) {
    BlockWeights weights;
    BlockGradients gradients;
    weigh(data, block, weights);
    gather_gradients(data, block, weights, gradients);
    const StressUpdate stress = update_stress<traits>(data, block, gradients);
    move(data, block);
    const Reached reached = weigh(data, block, weights);
    if constexpr (map == Map::yes) map_to_nodes(data, block, weights);
    report.box = joined(report.box, reached.box);
    report.internal_work += stress.internal_work;
    report.is_broken |= reached.is_lost || stress.is_broken;
  });
  return report;
}

void sweep_b(const SweepData& data) {
  for_each_block(data, [&](Block block) {
    BlockWeights weights;
    weigh(data, block, weights);
    gather_and_map_block(data, block, weights);
  });
}

template <SoilTraits traits>
Sweeps sweeps_for() {
  return {sweep_a<traits, Map::yes>, sweep_a<traits, Map::no>, sweep_b};
}

template <bool has_cone, bool has_softening>
Sweeps sweeps_for(bool has_layers) {
  return has_layers ? sweeps_for<SoilTraits{has_cone, has_softening, true}>() : sweeps_for<SoilTraits{has_cone, has_softening, false}>();
}

}  // namespace

Sweeps SLIDEZONE_SWEEPS(SoilTraits traits);

Sweeps SLIDEZONE_SWEEPS(SoilTraits traits) {
  if (traits.has_cone) return traits.has_softening ? sweeps_for<true, true>(traits.has_layers) : sweeps_for<true, false>(traits.has_layers);
  return traits.has_softening ? sweeps_for<false, true>(traits.has_layers) : sweeps_for<false, false>(traits.has_layers);
}

}  // namespace slidezone
