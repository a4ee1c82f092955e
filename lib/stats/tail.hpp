// The tail of a sample by a generalized Pareto distribution (GPD) of its exceedances over a threshold: quantiles beyond the data.
//
// For x above the threshold u, with a share s of the sample beyond u:
//   P(X > x) = s (1 + shape (x - u) / scale)^(-1 / shape)        shape 0: s exp(-(x - u) / scale); shape < 0: ends at u - scale / shape
//   the x that is exceeded with probability p < s:  u + scale ((s / p)^shape - 1) / shape
// Source: Pickands (1975); Coles (2001), "An introduction to statistical modeling of extreme values", chapter 4. Fitted by maximum
// likelihood. Interval of the quantile by the profile of its likelihood (Coles 4.3.3): all x for which the best fit through (x, p) loses
// at most chi^2_1(95 %) / 2 = 1.92 of the logarithm; s is taken as known. The upper end is infinite where the profile never falls so far.
// An extrapolation: it is as good as the assumption that the law of the exceedances beyond the data is that of those within.
// Censored runs count at their bound and diverged ones not at all: refuse samples that have either.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "stats/sample.hpp"

namespace slidezone {

struct TailFit {
  double threshold = 0;
  std::size_t exceedances = 0;
  double share = 0;  // of the sample beyond the threshold
  double scale = 0;
  double shape = 0;
  double distance = 0;  // Kolmogorov's, of the exceedances from the fit
};

/// Fewer exceedances than this say too little of a shape.
inline constexpr std::size_t least_exceedances = 30;

/// Threshold: the value that the largest tenth of the values exceeds, or the least_exceedances largest where that is more. Nothing where
/// half of the values do not give that many, or equal values leave nothing to fit.
std::optional<TailFit> tail_fit(std::span<const double> values);

/// The value that is exceeded with probability p < fit.share, with its profile interval; `values` are those that were fitted.
Estimate tail_quantile(const TailFit& fit, std::span<const double> values, double p);

}  // namespace slidezone
