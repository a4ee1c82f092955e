#include "stats/blocks.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

namespace slidezone {

static double student_limit(double degrees_of_freedom, double confidence) {
  return gsl_cdf_tdist_Qinv((1 - confidence) / 2, degrees_of_freedom);
}

Moments moments_of_all(const Blocks& blocks) {
  Moments moments;
  for (const auto& block : blocks) {
    for (const double value : block) moments.add(value);
  }
  return moments;
}

double mean_error(const Blocks& blocks) {
  const Moments moments = moments_of_all(blocks);
  double squares = 0;
  for (const auto& block : blocks) {
    double deviation = 0;
    for (const double value : block) deviation += value - moments.mean();
    squares += deviation * deviation;
  }
  const double count = static_cast<double>(blocks.size());
  return std::sqrt(count / (count - 1) * squares) / static_cast<double>(moments.count());  // 0 / 0 for one block
}

Interval mean_interval(const Blocks& blocks, double confidence) {
  const Moments moments = moments_of_all(blocks);
  if (blocks.size() < 2 || !(moments.variance() > 0)) return {};
  const double half_width = student_limit(static_cast<double>(blocks.size() - 1), confidence) * mean_error(blocks);
  return {moments.mean() - half_width, moments.mean() + half_width};
}

namespace {

/// V of the header and its standard error.
struct Scatter {
  double value = 0;
  double error = 0;
};

}  // namespace

/// The error follows from how V changes with the weight of each block: e_b^2 - V - 2 V e_b by itself and through m_2, and by
/// -4 d_b mean(e_b d_b) / m_2 through the mean, d_b as e_b the sum of x - m over the block.
static Scatter scatter_of_variance(const Blocks& blocks, const Moments& moments) {
  const double n = static_cast<double>(moments.count());
  const double count = static_cast<double>(blocks.size());
  const double m2 = moments.variance() * (n - 1) / n;
  std::vector<double> e, d;
  double squares = 0, products = 0;
  for (const auto& block : blocks) {
    e.push_back(0);
    d.push_back(0);
    for (const double value : block) {
      e.back() += count / n * (std::pow(value - moments.mean(), 2) / m2 - 1);
      d.back() += count / n * (value - moments.mean());
    }
    squares += e.back() * e.back() / count;
    products += e.back() * d.back() / count;
  }
  double of_weights = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    of_weights += std::pow(e[b] * e[b] - squares - 2 * squares * e[b] - 4 * d[b] * products / m2, 2);
  return {squares, std::sqrt(of_weights) / count};
}

double variance_error(const Blocks& blocks) {
  const Moments moments = moments_of_all(blocks);
  return moments.variance() * std::sqrt(scatter_of_variance(blocks, moments).value / static_cast<double>(blocks.size() - 1));
}

Interval variance_interval(const Blocks& blocks, double errors, double confidence) {
  const Moments moments = moments_of_all(blocks);
  const double n = static_cast<double>(moments.count());
  const double count = static_cast<double>(blocks.size());
  if (blocks.size() < 5 || !(moments.variance() > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double t = student_limit(count - 1, confidence);
  const double c = n / (n - t);
  const Scatter scatter = scatter_of_variance(blocks, moments);
  const double half_width = t * c * std::sqrt((scatter.value + errors * scatter.error + 3 * count / (n * n)) / (count - 1));
  return {c * moments.variance() * std::exp(-half_width), c * moments.variance() * std::exp(half_width)};
}

/// The variance of the share between blocks over that of independent runs; its bound where all runs agree.
static double design_effect(const Blocks& blocks, double share, double n) {
  const double count = static_cast<double>(blocks.size());
  double squares = 0;
  std::size_t largest = 0;
  for (const auto& block : blocks) {
    double deviation = 0;
    for (const double value : block) deviation += value - share;
    squares += deviation * deviation;
    largest = std::max(largest, block.size());
  }
  const double size = static_cast<double>(largest);
  if (share == 0 || share == 1) return largest > 1 ? size / (size - 1) : 1;
  return count / (count - 1) * squares / (n * share * (1 - share));
}

double effective_count(const Blocks& blocks, double confidence) {
  const Moments moments = moments_of_all(blocks);
  const double n = static_cast<double>(moments.count());
  const double count = static_cast<double>(blocks.size());
  if (count == n) return n;  // plain
  if (blocks.size() < 2) return 0;
  const double effect = design_effect(blocks, std::clamp(moments.mean(), 0.0, 1.0), n);
  const double few_blocks = std::pow(student_limit(n - 1, confidence) / student_limit(count - 1, confidence), 2);
  return effect > 0 ? std::min(n, n / effect * few_blocks) : n;
}

}  // namespace slidezone
