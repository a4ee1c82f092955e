#include "field/covariance_factor.hpp"

#include "core/error.hpp"

namespace slidezone {

using Cholesky = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;  // in place

static LowerTriangle packed(const Eigen::MatrixXd& lower) {
  LowerTriangle triangle{static_cast<std::size_t>(lower.rows()), {}};
  triangle.entries.reserve(triangle.size * (triangle.size + 1) / 2);
  for (Eigen::Index k = 0; k < lower.cols(); ++k)
    for (Eigen::Index i = k; i < lower.rows(); ++i) triangle.entries.push_back(lower(i, k));
  return triangle;
}

/// Lower triangular root of a matrix without its negative eigenvalues.
static Eigen::MatrixXd lower_root(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  const Eigen::VectorXd roots = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  const Eigen::MatrixXd root = solver.eigenvectors() * roots.asDiagonal();
  Eigen::MatrixXd upper = root.transpose().householderQr().matrixQR().triangularView<Eigen::Upper>();
  for (Eigen::Index i = 0; i < upper.rows(); ++i)
    if (upper(i, i) < 0) upper.row(i) = -upper.row(i);
  return upper.transpose();
}

CovarianceFactor clipped_factor(const Eigen::MatrixXd& covariance) {
  Eigen::MatrixXd lower = covariance;
  if (Cholesky(lower).info() == Eigen::Success) return {packed(lower), 0};
  lower = lower_root(covariance);
  return {packed(lower), (lower * lower.transpose() - covariance).cwiseAbs().maxCoeff()};
}

CovarianceFactor jittered_factor(Eigen::MatrixXd covariance) {
  const Eigen::VectorXd diagonal = covariance.diagonal();
  for (const double jitter : {0.0, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8}) {
    covariance.diagonal() = diagonal.array() + jitter;
    if (Cholesky(covariance).info() == Eigen::Success) return {packed(covariance), jitter};
    for (Eigen::Index k = 0; k < covariance.cols(); ++k)  // the upper half is as it was
      for (Eigen::Index i = k + 1; i < covariance.rows(); ++i) covariance(i, k) = covariance(k, i);
  }
  throw Error(ExitCode::data,
              "the covariance matrix is not positive definite, even with 1e-8 added to its diagonal; with correlation_of = \"physical\" "
              "there may be no Gaussian field behind the values");
}

}  // namespace slidezone
