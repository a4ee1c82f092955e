// Lower triangular factors L L^T = A of covariance matrices, also of those that rounding has made indefinite.
//
// Smooth functions (squared exponential, third-order Markov, Matern of high smoothness) have covariance matrices whose least
// eigenvalues lie below rounding once the scale is some 5 to 10 spacings; Cholesky's method then breaks down. Two guards:
//   clipped   eigenvalues below zero are set to zero and L comes from a QR factorisation of the root: A = V D V^T,
//             (V sqrt D)^T = Q R, L = R^T with a positive diagonal, which is Cholesky's factor where that exists. For the few
//             cells of one axis: it costs some 10 n^3.
//   jittered  the least of 1e-12, 1e-11, ... 1e-8 that makes Cholesky's method succeed is added to the diagonal.
#pragma once

#include <Eigen/Dense>

#include "field/triangular.hpp"

namespace slidezone {

struct CovarianceFactor {
  LowerTriangle lower;
  double error = 0;  // largest |L L^T - A|, but for rounding
};

CovarianceFactor clipped_factor(const Eigen::MatrixXd& covariance);

/// Throws ExitCode::data where 1e-8 is not enough: then the matrix is no covariance. Takes the matrix, to factor it in place.
CovarianceFactor jittered_factor(Eigen::MatrixXd covariance);

}  // namespace slidezone
