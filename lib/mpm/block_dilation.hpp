// B-bar in the material point method: all points of a cell share one volume change and, in the force, one mean stress.
//
// With V the volumes of the points in a cell c and d = L_xx + L_yy the rate of volume change:
//   d_c = sum V d / sum V   replaces d in the strain of each point, half of the difference in L_xx and half in L_yy,
//   p_c = sum V p / sum V   replaces p = (s_xx + s_yy) / 2 in the force of each point on the nodes.
// The second follows from the first by virtual power, sum V s : L = sum V (dev s : dev L + p_c d): both together conserve
// energy; either alone is unstable. Both averages of one step are taken over the same cells: MUSL and USL gather the strain
// with the positions with which the forces were mapped.
// Why: four points a cell are more volume constraints than the cell's nodes can meet at nu -> 1/2, and the mesh locks
// (Hughes 1980 for finite elements). Included by sweeps.cpp alone.
#pragma once

#include "mpm/block_stress.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

/// The cell that point p lies in. Its weights tell: s counts cells from the first node that it reaches.
template <class Real>
[[gnu::always_inline]] inline int cell_of(const BlockWeights<Real>& weights, int p, int rows) {
  return weights.first_node[p] + (weights.s_x[p] >= 1 ? rows : 0) + (weights.s_y[p] >= 1 ? 1 : 0);
}

/// Keeps the gradients for later, and sums V and V d over cells.
template <class Real>
[[gnu::always_inline]] inline void sum_dilation(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights,
                                                const BlockGradients<Real>& gradients) {
  const Dilation<Real>& dilation = *data.dilation;
  for (int p = 0; p < block.count; ++p) {
    const std::size_t point = block.first + static_cast<std::size_t>(p);
    const int cell = cell_of(weights, p, data.storage.rows);
    dilation.xx[point] = gradients.xx[p];
    dilation.xy[point] = gradients.xy[p];
    dilation.yx[point] = gradients.yx[p];
    dilation.yy[point] = gradients.yy[p];
    dilation.cell[point] = cell;
    dilation.cell_volume[cell] += data.volume[point];
    dilation.cell_dilation[cell] += data.volume[point] * (gradients.xx[p] + gradients.yy[p]);
  }
}

/// The kept gradients with the mean volume change of their cells.
template <class Real>
[[gnu::always_inline]] inline void mean_gradients(const SweepData<Real>& data, auto block, BlockGradients<Real>& gradients) {
  const Dilation<Real>& dilation = *data.dilation;
  for (int p = 0; p < block.count; ++p) {
    const std::size_t point = block.first + static_cast<std::size_t>(p);
    const int cell = dilation.cell[point];
    const Real mean = dilation.cell_dilation[cell] / dilation.cell_volume[cell];
    const Real half = Real{0.5} * (mean - (dilation.xx[point] + dilation.yy[point]));
    gradients.xx[p] = dilation.xx[point] + half;
    gradients.yy[p] = dilation.yy[point] + half;
    gradients.xy[p] = dilation.xy[point];
    gradients.yx[p] = dilation.yx[point];
  }
}

/// Sums V and V p over the cells of the moved points.
template <class Real>
[[gnu::always_inline]] inline void sum_pressure(const SweepData<Real>& data, auto block, const BlockWeights<Real>& weights) {
  const Dilation<Real>& dilation = *data.dilation;
  for (int p = 0; p < block.count; ++p) {
    const std::size_t point = block.first + static_cast<std::size_t>(p);
    const int cell = cell_of(weights, p, data.storage.rows);
    dilation.cell[point] = cell;
    dilation.cell_now_volume[cell] += data.volume[point];
    dilation.cell_pressure[cell] += data.volume[point] * Real{0.5} * (data.xx[point] + data.yy[point]);
  }
}

/// Normal stresses with the mean of their cells.
template <class Real>
struct MeanStress {
  Real xx[block_size], yy[block_size];
};

template <class Real>
[[gnu::always_inline]] inline void mean_stress(const SweepData<Real>& data, auto block, MeanStress<Real>& mean) {
  const Dilation<Real>& dilation = *data.dilation;
  for (int p = 0; p < block.count; ++p) {
    const std::size_t point = block.first + static_cast<std::size_t>(p);
    const int cell = dilation.cell[point];
    const Real difference = dilation.cell_pressure[cell] / dilation.cell_now_volume[cell] - Real{0.5} * (data.xx[point] + data.yy[point]);
    mean.xx[p] = data.xx[point] + difference;
    mean.yy[p] = data.yy[point] + difference;
  }
}

}  // namespace
}  // namespace slidezone
