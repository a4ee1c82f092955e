// Statistics: two series of the same realizations.
#include "stats/paired.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"

namespace slidezone {
namespace {

TEST(Paired, DifferenceAndRatioOfASeriesAndItsDouble) {
  std::vector<Pair> pairs;
  for (const double value : {3.0, 1.0, 4.0, 1.0, 5.0, 9.0, 2.0, 6.0}) pairs.push_back({2 * value + 1, value});
  EXPECT_DOUBLE_EQ(mean_difference(pairs).value, 31.0 / 8 + 1);
  EXPECT_DOUBLE_EQ(sd_ratio(pairs).value, 2);
  EXPECT_NEAR(correlation(pairs), 1, 1e-12);
  pairs[0].b = 30;
  EXPECT_LT(sd_ratio(pairs).interval.low, sd_ratio(pairs).value);
}

TEST(Paired, AConstantSeriesHasNoRatio) {
  const std::vector<Pair> pairs = {{1, 0}, {2, 0}, {4, 0}};
  EXPECT_TRUE(std::isnan(sd_ratio(pairs).value));
  EXPECT_TRUE(std::isnan(correlation(pairs)));
}

/// 500 studies of 100 pairs: a true coverage of 95 % is found within 2 % (two standard errors).
TEST(Paired, RatiosOfSdsAreCovered) {
  int hits = 0;
  for (std::uint32_t study = 1; study <= 500; ++study) {
    std::vector<double> z(200);
    fill_normals(z, {1, purpose("paired"), study});
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < 100; ++i) pairs.push_back({1.5 * (0.8 * z[2 * i] + 0.6 * z[2 * i + 1]), z[2 * i]});
    const Interval interval = sd_ratio(pairs).interval;
    hits += interval.low <= 1.5 && 1.5 <= interval.high;
  }
  EXPECT_NEAR(hits / 500.0, 0.95, 0.025);
}

}  // namespace
}  // namespace slidezone
