// The exact Cholesky factor of the separable single exponential autocorrelation.
//
// Eq. 24: rho(dx, dy) = exp(-2 |dx| / scale_x - 2 |dy| / scale_y), scales of fluctuation in metres. On a mesh it is the
// Kronecker product of one matrix per axis, A_ij = a^|i-j| with a = exp(-2 h / scale), spacing h, so that its factor
// (Eqs. 25-27) is the product of their factors
//
//   L_ij = a^(i-j) (j = 0 ? 1 : b)  for i >= j,  b = sqrt(1 - a^2) = sqrt(-expm1(-4 h / scale)),
//
// and L z is an autoregressive sweep of first order, AR(1):  g_0 = z_0,  g_i = a g_(i-1) + b z_i.
// Exact to rounding for any scale and mesh, where a dense factor loses digits as a nears 1; 2 multiplications per cell and axis.
#pragma once

#include <span>

namespace slidezone {

/// One axis of the factor.
struct ExponentialFactor {
  double memory = 0;      // a
  double innovation = 1;  // b
};

ExponentialFactor exponential_factor(double spacing, double scale);

/// Independent standard normals, rows of `row_size`, become correlated along the rows, or from row to row.
void correlate_along_rows(std::span<double> values, std::size_t row_size, ExponentialFactor factor);
void correlate_across_rows(std::span<double> values, std::size_t row_size, ExponentialFactor factor);

}  // namespace slidezone
