#include "field/mesh_covariance.hpp"

#include <cmath>

#include "field/cell_correlation.hpp"

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
  CellCorrelation correlation(model);
  for (Eigen::Index i = 0; i < first.size(); ++i) first(i) = correlation(static_cast<double>(i), 0);
  return toeplitz(first);
}

Eigen::MatrixXd column_covariance(const FieldModel& model) {
  Eigen::VectorXd first(model.mesh.cells_y);
  CellCorrelation correlation(model);
  for (Eigen::Index i = 0; i < first.size(); ++i) first(i) = correlation(0, static_cast<double>(i));
  return toeplitz(first / correlation(0, 0));
}

Eigen::MatrixXd full_covariance(const FieldModel& model) {
  CellCorrelation correlation(model);
  const Eigen::Index columns = model.mesh.cells_x, rows = model.mesh.cells_y;
  Eigen::MatrixXd lags(2 * columns - 1, 2 * rows - 1);  // every lag once
  for (Eigen::Index j = 0; j < lags.cols(); ++j)
    for (Eigen::Index i = 0; i < lags.rows(); ++i)
      lags(i, j) = correlation(static_cast<double>(i - columns + 1), static_cast<double>(j - rows + 1));
  Eigen::MatrixXd matrix(columns * rows, columns * rows);
  for (Eigen::Index b = 0; b < matrix.cols(); ++b)
    for (Eigen::Index a = 0; a < matrix.rows(); ++a)
      matrix(a, b) = lags(a % columns - b % columns + columns - 1, a / columns - b / columns + rows - 1);
  return matrix;
}

}  // namespace slidezone
