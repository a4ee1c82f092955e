#include "field/karhunen_loeve.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "field/cell_correlation.hpp"
#include "field/mesh_covariance.hpp"

namespace slidezone {

/// The strongest products of modes of the two axes that hold the share `wanted` of the variance.
static void keep_strongest(KarhunenLoeve& expansion, const Eigen::VectorXd& lambda_x, const Eigen::VectorXd& lambda_y, double wanted) {
  for (Eigen::Index y = 0; y < lambda_y.size(); ++y)
    for (Eigen::Index x = 0; x < lambda_x.size(); ++x)
      expansion.modes.push_back({x, y, std::sqrt(std::max(0.0, lambda_x(x)) * std::max(0.0, lambda_y(y)))});
  std::ranges::stable_sort(expansion.modes, std::greater<>(), &KarhunenLoeve::Mode::amplitude);
  const double total = lambda_x.sum() * lambda_y.sum();
  double sum = 0;
  std::size_t count = 0;
  while (count < expansion.modes.size() && sum < wanted * total) sum += std::pow(expansion.modes[count++].amplitude, 2);
  expansion.modes.resize(count);
  expansion.variance_kept = sum / total;
}

/// The largest loss of variance at a cell.
static double largest_loss(const KarhunenLoeve& expansion, double full_variance) {
  Eigen::MatrixXd lambda = Eigen::MatrixXd::Zero(expansion.modes_x.cols(), expansion.modes_y.cols());
  for (const KarhunenLoeve::Mode& mode : expansion.modes) lambda(mode.x, mode.y) = mode.amplitude * mode.amplitude;
  const Eigen::MatrixXd variance = expansion.modes_x.cwiseAbs2() * lambda * expansion.modes_y.cwiseAbs2().transpose();
  return full_variance - variance.minCoeff();
}

/// Negative eigenvalues beyond rounding are not cut off: their matrix is no covariance.
static void check_definiteness(const Eigen::VectorXd& lambda) {
  constexpr double rounding = 1e-9;
  if (lambda.minCoeff() >= -rounding * lambda.maxCoeff()) return;
  throw Error(ExitCode::data,
              "the covariance matrix is not positive definite: its least eigenvalue is " +
                  format_brief(lambda.minCoeff() / lambda.maxCoeff(), 2) +
                  " times the greatest; with correlation_of = \"physical\" there may be no Gaussian field behind the values");
}

KarhunenLoeve karhunen_loeve(const FieldModel& model) {
  using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
  KarhunenLoeve expansion;
  const bool is_product = CellCorrelation(model).is_separable();
  const Solver x(is_product ? row_covariance(model) : full_covariance(model));
  const Solver y(is_product ? column_covariance(model) : Eigen::MatrixXd::Ones(1, 1));
  check_definiteness(x.eigenvalues());
  check_definiteness(y.eigenvalues());
  expansion.modes_x = x.eigenvectors();
  expansion.modes_y = y.eigenvectors();
  keep_strongest(expansion, x.eigenvalues(), y.eigenvalues(), model.variance_kept);
  expansion.covariance_error = largest_loss(expansion, CellCorrelation(model)(0, 0));
  return expansion;
}

void fill(std::span<double> values, const KarhunenLoeve& expansion, RandomStream stream) {
  std::vector<double> normals(expansion.modes.size());
  fill_normals(normals, stream);
  Eigen::MatrixXd amplitudes = Eigen::MatrixXd::Zero(expansion.modes_x.cols(), expansion.modes_y.cols());
  for (std::size_t k = 0; k < normals.size(); ++k)
    amplitudes(expansion.modes[k].x, expansion.modes[k].y) = expansion.modes[k].amplitude * normals[k];
  Eigen::Map<Eigen::MatrixXd> field(values.data(), expansion.modes_x.rows(), expansion.modes_y.rows());  // a column is a row of cells
  field.noalias() = expansion.modes_x * (amplitudes * expansion.modes_y.transpose());
}

}  // namespace slidezone
