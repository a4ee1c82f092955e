// Covariances of local averages of a field over intervals of one axis (Vanmarcke 1983).
//
// Averages over two intervals of length T whose starts lie k T apart have the covariance
//
//   C_k = integral from -1 to 1 of (1 - |u|) rho(|k + u| T) du,
//
// and C_0 is the variance function of T. By adaptive quadrature of GSL to 1e-12, in parts that no decay escapes.
#pragma once

#include "field/model.hpp"

namespace slidezone {

/// C_k for T in scales of fluctuation.
double average_covariance(Autocorrelation function, double smoothness, double length, double k);

}  // namespace slidezone
