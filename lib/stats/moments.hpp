// Moments of a series in one pass: mean, variance, skewness, kurtosis, extremes.
//
// Symbols: n values x with mean m; M_k = sum of (x - m)^k. Variance s^2 = M_2 / (n - 1). Skewness g_1 = (M_3 / n) / (M_2 / n)^1.5
// and kurtosis b_2 = (M_4 / n) / (M_2 / n)^2, which is 3 for a Normal distribution; both are the plain moment ratios.
//
// Source: Welford (1962), for the higher moments Pebay (2008), "Formulas for robust, one-pass parallel computation of covariances
// and arbitrary-order statistical moments", SAND2008-6212. The first value is taken off every later one before the update: the
// difference of near numbers is exact, so series like 10000000.2 +- 0.1 lose no digits to their offset.
// Accuracy: NIST's certified mean and standard deviation to 14 digits, or to the digits that double input leaves.
//
// What too few values cannot tell is nan: the mean of none, the variance of one, the skewness of a constant.
#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace slidezone {

class Moments {
 public:
  void add(double value);

  std::size_t count() const { return count_; }
  double mean() const;
  double variance() const;
  double standard_deviation() const;
  double skewness() const;
  double kurtosis() const;
  double minimum() const;
  double maximum() const;

 private:
  std::size_t count_ = 0;
  double first_ = 0;  // offset of the series
  double mean_ = 0;   // of the values less the first
  double M2_ = 0;
  double M3_ = 0;
  double M4_ = 0;
  double minimum_ = std::numeric_limits<double>::quiet_NaN();
  double maximum_ = std::numeric_limits<double>::quiet_NaN();
};

Moments moments_of(std::span<const double> values);

}  // namespace slidezone
