#include "stats/moments.hpp"

#include <cmath>

namespace slidezone {

static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void Moments::add(double value) {
  if (count_ == 0) first_ = minimum_ = maximum_ = value;
  minimum_ = std::fmin(minimum_, value);
  maximum_ = std::fmax(maximum_, value);
  ++count_;
  const double n = static_cast<double>(count_);
  const double delta = (value - first_) - mean_;
  const double delta_n = delta / n;
  const double growth = delta * delta_n * (n - 1);  // of M2
  mean_ += delta_n;
  M4_ += growth * delta_n * delta_n * (n * n - 3 * n + 3) + 6 * delta_n * delta_n * M2_ - 4 * delta_n * M3_;  // Pebay, Eq. 3.1
  M3_ += growth * delta_n * (n - 2) - 3 * delta_n * M2_;
  M2_ += growth;
}

double Moments::mean() const { return count_ == 0 ? nan : first_ + mean_; }

double Moments::variance() const { return count_ < 2 ? nan : M2_ / static_cast<double>(count_ - 1); }

double Moments::standard_deviation() const { return std::sqrt(variance()); }

double Moments::skewness() const { return M2_ > 0 ? std::sqrt(static_cast<double>(count_)) * M3_ / std::pow(M2_, 1.5) : nan; }

double Moments::kurtosis() const { return M2_ > 0 ? static_cast<double>(count_) * M4_ / (M2_ * M2_) : nan; }

double Moments::minimum() const { return minimum_; }

double Moments::maximum() const { return maximum_; }

Moments moments_of(std::span<const double> values) {
  Moments moments;
  for (const double value : values) moments.add(value);
  return moments;
}

}  // namespace slidezone
