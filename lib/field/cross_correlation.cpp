#include "field/cross_correlation.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "field/nataf.hpp"

namespace slidezone {

static Eigen::MatrixXd eigen_matrix(const std::vector<std::vector<double>>& rows) {
  const auto size = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j) matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return matrix;
}

/// With least eigenvalue 1 + m of a matrix I + O, I + t O is positive definite for t < -1/m.
static std::string flaw_of(const Eigen::MatrixXd& matrix) {
  constexpr double least_allowed = 1e-10;
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(0);
  if (least > least_allowed) return "";
  const double share = std::floor(100 / (1 - least)) / 100;
  return "is not positive definite: its least eigenvalue is " + format_brief(least, 2) +
         ", so these correlations contradict each other; all of them times " + format_brief(std::min(share, 0.99)) + " would do";
}

std::string flaw_of_correlations(const std::vector<std::vector<double>>& matrix) { return flaw_of(eigen_matrix(matrix)); }

/// The matrix of the Gaussian fields.
static Eigen::MatrixXd gaussian_matrix(const CrossCorrelation& correlated, const std::vector<MarginalTransform>& transforms) {
  Eigen::MatrixXd matrix = eigen_matrix(correlated.matrix);
  if (correlated.correlation_of == CorrelationOf::gaussian) return matrix;
  std::vector<Nataf> natafs;
  for (const MarginalTransform& transform : transforms) natafs.emplace_back(transform);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) try {
        matrix(i, j) = matrix(j, i) =
            gaussian_correlation(natafs[static_cast<std::size_t>(i)], natafs[static_cast<std::size_t>(j)], matrix(i, j));
      } catch (const Error& error) {
        throw Error(error.code(), "row " + std::to_string(i + 1) + ", column " + std::to_string(j + 1) + " of the matrix: " + error.what());
      }
  return matrix;
}

Eigen::MatrixXd mixing_of(const CrossCorrelation& correlated, const std::vector<MarginalTransform>& transforms) {
  const Eigen::MatrixXd matrix = gaussian_matrix(correlated, transforms);
  const std::string flaw = flaw_of(matrix);
  if (!flaw.empty()) throw Error(ExitCode::data, "the matrix of the Gaussian fields behind the values " + flaw);
  return matrix.llt().matrixL();
}

}  // namespace slidezone
