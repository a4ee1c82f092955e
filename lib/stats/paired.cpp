#include "stats/paired.hpp"

#include <cmath>
#include <functional>

namespace slidezone {

static Sample sample_of(std::span<const Pair> pairs, const std::function<double(const Pair&)>& value) {
  Sample sample;
  for (const Pair& pair : pairs) sample.push_back({value(pair), Knowledge::exact, pair.block});
  return sample;
}

static Moments moments_of(std::span<const Pair> pairs, double Pair::*series) {
  Moments moments;
  for (const Pair& pair : pairs) moments.add(pair.*series);
  return moments;
}

Estimate mean_difference(std::span<const Pair> pairs) {
  return mean_estimate(sample_of(pairs, [](const Pair& pair) { return pair.a - pair.b; }));
}

Estimate sd_ratio(std::span<const Pair> pairs) {
  const Moments a = moments_of(pairs, &Pair::a), b = moments_of(pairs, &Pair::b);
  const double ratio = a.standard_deviation() / b.standard_deviation();
  if (!(a.variance() > 0 && b.variance() > 0)) return {std::numeric_limits<double>::quiet_NaN(), {}};
  const Sample changes = sample_of(pairs, [&](const Pair& pair) {  // n / (n - 1) of their size: the variances' divisor, not m_2's
    return std::pow(pair.a - a.mean(), 2) / a.variance() - std::pow(pair.b - b.mean(), 2) / b.variance();
  });
  const Estimate change = mean_estimate(changes);
  return {ratio, {ratio * std::exp((change.interval.low - change.value) / 2), ratio * std::exp((change.interval.high - change.value) / 2)}};
}

double correlation(std::span<const Pair> pairs) {
  const Moments a = moments_of(pairs, &Pair::a), b = moments_of(pairs, &Pair::b);
  double sum = 0;
  for (const Pair& pair : pairs) sum += (pair.a - a.mean()) * (pair.b - b.mean());
  return sum / static_cast<double>(pairs.size() - 1) / (a.standard_deviation() * b.standard_deviation());
}

}  // namespace slidezone
