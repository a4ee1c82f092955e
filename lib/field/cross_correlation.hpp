// Correlation between the random fields of several parameters.
//
// Independent Gaussian fields z_j of one autocorrelation rho become g_i = sum_j L_ij z_j with the Cholesky factor L of the matrix R
// of their correlations at a point: each g_i has the autocorrelation rho, and g_i(x) and g_j(x') have the correlation R_ij rho(x - x')
// (Fenton and Griffiths 2008; Vorechovsky 2008). Exact. Fields of different autocorrelation have no such product, so they are refused.
//
// R is that of the Gaussian fields, as given or, for correlations given between the values, by the Nataf model pair by pair:
// rho_ij = sum_k a_k b_k r^k / sqrt(sum a_k^2 sum b_k^2) with the Hermite coefficients of the two transforms (field/nataf.hpp).
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <string>
#include <vector>

#include "field/marginal.hpp"
#include "field/model.hpp"

namespace slidezone {

struct CrossCorrelation {
  std::vector<std::size_t> fields;          // indices into the list of fields
  std::vector<std::vector<double>> matrix;  // symmetric, ones on its diagonal
  CorrelationOf correlation_of = CorrelationOf::gaussian;
};

/// What is wrong with a matrix of correlations that is not positive definite, and how much weaker ones would do; empty where it is.
std::string flaw_of_correlations(const std::vector<std::vector<double>>& matrix);

/// L of the fields, by their transforms in the order of `correlated.fields`. Throws ExitCode::data, naming the pair, for a correlation
/// that two marginals cannot have, and where the Gaussian matrix is not positive definite.
Eigen::MatrixXd mixing_of(const CrossCorrelation& correlated, const std::vector<MarginalTransform>& transforms);

}  // namespace slidezone
