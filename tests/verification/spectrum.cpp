#include "verification/spectrum.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <utility>

#include "grid/gimp.hpp"

namespace slidezone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Shape functions along one axis of a point at x, in metres and 1/m.
struct AxisShape {
  int first;
  AxisValues value, slope;
};

AxisShape axis_shape(double x, double cell, double half_size) {
  const double first = std::floor(x / cell - half_size);
  const AxisWeights weights = axis_weights(x / cell, first, half_size, half_size > 0 ? 1 / (4 * half_size) : 0);
  AxisShape shape{static_cast<int>(first), shape_values(weights), shape_slopes(weights)};
  for (double& slope : shape.slope.node) slope /= cell;
  return shape;
}

/// Values and gradients of all points at all nodes that they reach: one row a point, one column a node.
struct Shape {
  MatrixXd value, slope_x, slope_y;
};

Shape shape_of(const Model& model) {
  const Points& points = model.points;
  const bool is_linear = model.method.shape_functions == ShapeFunctions::linear;
  const auto n = static_cast<Index>(points.count());
  const Index most = 9 * n;
  Shape shape{MatrixXd::Zero(n, most), MatrixXd::Zero(n, most), MatrixXd::Zero(n, most)};
  std::map<std::pair<int, int>, Index> number;
  for (Index p = 0; p < n; ++p) {
    const auto k = static_cast<std::size_t>(p);
    const AxisShape x = axis_shape(points.x[k], model.grid.cell_x, is_linear ? 0 : 0.5 * model.point_spacing_x / model.grid.cell_x);
    const AxisShape y = axis_shape(points.y[k], model.grid.cell_y, is_linear ? 0 : 0.5 * model.point_spacing_y / model.grid.cell_y);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Index node = number.try_emplace({x.first + i, y.first + j}, static_cast<Index>(number.size())).first->second;
        shape.value(p, node) = x.value.node[i] * y.value.node[j];
        shape.slope_x(p, node) = x.slope.node[i] * y.value.node[j];
        shape.slope_y(p, node) = x.value.node[i] * y.slope.node[j];
      }
  }
  const auto nodes = static_cast<Index>(number.size());
  return {shape.value.leftCols(nodes), shape.slope_x.leftCols(nodes), shape.slope_y.leftCols(nodes)};
}

/// The columns of nodes that carry a velocity.
MatrixXd columns(const MatrixXd& matrix, const std::vector<Index>& kept) {
  MatrixXd result(matrix.rows(), static_cast<Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k) result.col(static_cast<Index>(k)) = matrix.col(kept[k]);
  return result;
}

/// Volume change L_xx + L_yy of each point by the nodes' velocities (x of all, then y of all), averaged over cells for B-bar.
MatrixXd dilation(const Model& model, const Shape& shape) {
  MatrixXd own(shape.value.rows(), 2 * shape.value.cols());
  own << shape.slope_x, shape.slope_y;
  if (model.method.anti_locking == AntiLocking::none) return own;
  std::map<std::pair<double, double>, std::pair<double, VectorXd>> sums;  // V and V d by cell
  const auto cell = [&](std::size_t p) {
    return std::pair{std::floor(model.points.x[p] / model.grid.cell_x), std::floor(model.points.y[p] / model.grid.cell_y)};
  };
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    auto& [volume, sum] = sums.try_emplace(cell(p), 0, VectorXd::Zero(own.cols())).first->second;
    volume += model.points.volume[p];
    sum += model.points.volume[p] * own.row(static_cast<Index>(p)).transpose();
  }
  MatrixXd mean(own.rows(), own.cols());
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    const auto& [volume, sum] = sums.at(cell(p));
    mean.row(static_cast<Index>(p)) = sum.transpose() / volume;
  }
  return mean;
}

/// sum V B^T D B, as the shares of volume change (modulus lambda + G) and of both shears (modulus G).
MatrixXd stiffness(const Model& model, const Shape& shape) {
  const auto n = shape.value.rows();
  VectorXd by_dilation(n);
  VectorXd by_shear(n);
  for (Index p = 0; p < n; ++p) {
    const auto k = static_cast<std::size_t>(p);
    const ElasticModuli moduli = elastic_moduli(soil_of(model, model.points, k));
    by_dilation(p) = model.points.volume[k] * (moduli.bulk + moduli.shear / 3);
    by_shear(p) = model.points.volume[k] * moduli.shear;
  }
  const MatrixXd change = dilation(model, shape);
  MatrixXd stretch(n, change.cols());
  stretch << shape.slope_x, -shape.slope_y;
  MatrixXd shear(n, change.cols());
  shear << shape.slope_y, shape.slope_x;
  return change.transpose() * by_dilation.asDiagonal() * change + stretch.transpose() * by_shear.asDiagonal() * stretch +
         shear.transpose() * by_shear.asDiagonal() * shear;
}

}  // namespace

double longest_stable_step(const Model& model) {
  Shape shape = shape_of(model);
  const VectorXd mass = Eigen::Map<const VectorXd>(model.points.mass.data(), static_cast<Index>(model.points.count()));
  const VectorXd all = shape.value.transpose() * mass;
  std::vector<Index> kept;
  for (Index node = 0; node < all.size(); ++node)
    if (all(node) > 1e-9 * mass.maxCoeff()) kept.push_back(node);  // as in nodes.hpp: lighter ones carry no velocity
  shape = {columns(shape.value, kept), columns(shape.slope_x, kept), columns(shape.slope_y, kept)};

  const VectorXd lumped = shape.value.transpose() * mass;
  const MatrixXd consistent = shape.value.transpose() * mass.asDiagonal() * shape.value;
  VectorXd root(2 * lumped.size());
  root << lumped.cwiseSqrt(), lumped.cwiseSqrt();
  const VectorXd scale = root.cwiseInverse();
  // S and A between velocities times the root of the mass, where both are symmetric
  const auto nodes = lumped.size();
  MatrixXd kept_part = MatrixXd::Zero(2 * nodes, 2 * nodes);
  kept_part.topLeftCorner(nodes, nodes) = kept_part.bottomRightCorner(nodes, nodes) = consistent;
  kept_part = scale.asDiagonal() * kept_part * scale.asDiagonal();
  const MatrixXd square = scale.asDiagonal() * stiffness(model, shape) * scale.asDiagonal();
  const MatrixXd part =
      model.method.update_order == UpdateOrder::usl ? MatrixXd(2 * MatrixXd::Identity(2 * nodes, 2 * nodes) - kept_part) : kept_part;
  const double greatest = Eigen::EigenSolver<MatrixXd>(part * square, false).eigenvalues().real().maxCoeff();
  return 2 / std::sqrt(greatest);
}

}  // namespace slidezone
