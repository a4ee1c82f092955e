// Distributions fitted to a sample: parameters, density, cumulative, tail, likelihood.
//
//   family     parameters                 fitted by
//   normal     mean, sd                   mean and sd (n - 1) of x
//   lognormal  lambda, zeta               mean and sd (n - 1) of ln x (completes Eq. 28)
//   gamma      shape, scale               maximum likelihood: ln k - psi(k) = ln mean(x) - mean(ln x), scale = mean / k
//   weibull    shape, scale               maximum likelihood: sum x^k ln x / sum x^k - 1 / k = mean(ln x), scale = mean(x^k)^(1/k)
//   gev        location, scale, shape     maximum likelihood by the simplex of Nelder and Mead, from the L-moments of Hosking (1990)
// GEV: F(x) = exp(-(1 + shape (x - location) / scale)^(-1 / shape)); shape > 0 is heavy-tailed, shape < 0 has an upper end, 0 is Gumbel.
// Lognormal, gamma and weibull live on x > 0. Locations and scales in the unit of x, lambda and zeta in its logarithm.
// Accuracy: likelihoods of gamma and weibull are solved to rounding, of the GEV to 1e-8 of its parameters.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stats/sample.hpp"

namespace slidezone {

enum class Family { normal, lognormal, gamma, weibull, gev };

inline constexpr std::array families = {Family::normal, Family::lognormal, Family::gamma, Family::weibull, Family::gev};

/// "normal", "lognormal", "gamma", "weibull", "gev".
std::string name_of(Family family);

/// As in the table above, e.g. {"lambda", "zeta"}.
const std::vector<std::string>& parameter_names(Family family);

struct Fit {
  Family family = Family::normal;
  std::vector<double> parameters;  // in the order of their names
};

/// Nothing for fewer than 2 values (GEV: 5), equal values, values <= 0 where the family wants them above, and a GEV without a maximum of
/// its likelihood at a shape above -1.
std::optional<Fit> fit_of(Family family, std::span<const double> values);

/// 95 % intervals of the parameters: those of mean and sd (sample.hpp) for normal and lognormal; nothing for the others.
std::optional<std::array<Interval, 2>> parameter_intervals(Family family, const Sample& sample);

/// Density, P(X <= x) and P(X > x) of the fit.
double density(const Fit& fit, double x);
double cumulative(const Fit& fit, double x);
double tail(const Fit& fit, double x);

/// Akaike's information criterion, 2 k - 2 ln(likelihood), k parameters by maximum likelihood (normal, lognormal: sd with n, not n - 1).
/// The smaller, the better; differences below 2 say little (Burnham and Anderson 2002).
double akaike_criterion(const Fit& fit, std::span<const double> values);

}  // namespace slidezone
