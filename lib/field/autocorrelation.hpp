// Autocorrelation functions of one lag, and of two on a plane.
//
// Each is written in t = |lag| / scale of fluctuation, and scaled so that its integral over all lags is the scale of fluctuation
// (Vanmarcke 1983):
//   single exponential   exp(-2 t)                                  Eq. 24
//   squared exponential  exp(-pi t^2)
//   second-order Markov  (1 + 4 t) exp(-4 t)
//   third-order Markov   (1 + b + b^2 / 3) exp(-b), b = 16 t / 3
//   cosine exponential   exp(-t) cos t
//   binary noise         1 - t for t < 1, else 0
//   Matern               2^(1-nu) / Gamma(nu) s^nu K_nu(s), s = 2 sqrt(pi) Gamma(nu + 1/2) / Gamma(nu) t   (Matern 1960)
//   spherical            1 - 3/2 h + h^3 / 2 for h < 1, else 0, h = 3 t / 4
// Matern of smoothness 1/2, 3/2, 5/2 is the single exponential, the second-order and the third-order Markov function.
//
// All are positive definite on a line, and products of two on the plane. As functions of an elliptical lag all but binary noise
// are positive definite on the plane too.
#pragma once

#include "field/model.hpp"

namespace slidezone {

/// rho at t = |lag| / scale >= 0; smoothness matters for Matern alone.
double autocorrelation(Autocorrelation function, double smoothness, double t);

/// Correlation between points (dx, dy) apart, without the nugget.
double autocorrelation(const Correlation& correlation, double dx, double dy);

/// Whether the correlation is a product of one function of dx and one of dy.
bool is_separable(const Correlation& correlation);

}  // namespace slidezone
