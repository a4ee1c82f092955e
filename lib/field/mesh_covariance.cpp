#include "field/mesh_covariance.hpp"

#include <cmath>

#include "field/autocorrelation.hpp"

namespace slidezone {

static Eigen::MatrixXd toeplitz(const Eigen::VectorXd& first_row) {
  const Eigen::Index n = first_row.size();
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) matrix(i, j) = first_row(std::abs(i - j));
  return matrix;
}

Eigen::MatrixXd row_covariance(const FieldModel& model) {
  Eigen::VectorXd first(model.mesh.cells_x);
  for (Eigen::Index i = 0; i < first.size(); ++i)
    first(i) = autocorrelation(model.correlation, static_cast<double>(i) * model.mesh.cell_x, 0);
  return toeplitz(first);
}

Eigen::MatrixXd column_covariance(const FieldModel& model) {
  Eigen::VectorXd first(model.mesh.cells_y);
  for (Eigen::Index i = 0; i < first.size(); ++i)
    first(i) = autocorrelation(model.correlation, 0, static_cast<double>(i) * model.mesh.cell_y);
  return toeplitz(first);
}

Eigen::MatrixXd full_covariance(const FieldModel& model) {
  const Eigen::Index columns = model.mesh.cells_x, rows = model.mesh.cells_y;
  Eigen::MatrixXd lags(2 * columns - 1, 2 * rows - 1);  // every lag once
  for (Eigen::Index j = 0; j < lags.cols(); ++j)
    for (Eigen::Index i = 0; i < lags.rows(); ++i)
      lags(i, j) = autocorrelation(model.correlation, static_cast<double>(i - columns + 1) * model.mesh.cell_x,
                                   static_cast<double>(j - rows + 1) * model.mesh.cell_y);
  Eigen::MatrixXd matrix(columns * rows, columns * rows);
  for (Eigen::Index b = 0; b < matrix.cols(); ++b)
    for (Eigen::Index a = 0; a < matrix.rows(); ++a)
      matrix(a, b) = lags(a % columns - b % columns + columns - 1, a / columns - b / columns + rows - 1);
  return matrix;
}

}  // namespace slidezone
