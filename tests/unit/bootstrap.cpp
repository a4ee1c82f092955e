// Statistics: intervals by the bootstrap.
#include "stats/bootstrap.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "stats/moments.hpp"
#include "stats_samples.hpp"

namespace slidezone {
namespace {

TEST(Bootstrap, MatchesBootOfR) {
  // boot.ci(type = "bca") with R = 200000: mean (9.89, 11.48), variance (2.203, 8.733).
  const MomentIntervals found = bootstrap_intervals(blocks_of(1, distances_25), "test", {.resamples = 100'000, .seed = 1});
  EXPECT_NEAR(found.mean.low, 9.89, 0.01);
  EXPECT_NEAR(found.mean.high, 11.48, 0.01);
  EXPECT_NEAR(found.variance.low, 2.203, 0.03);  // the ends scatter by some sd 0.01 and 0.05 at 100000 resamples
  EXPECT_NEAR(found.variance.high, 8.733, 0.15);
}

TEST(Bootstrap, IsReproducibleAndFollowsItsSeed) {
  const MomentIntervals first = bootstrap_intervals(blocks_of(1, distances_25), "test", {});
  const MomentIntervals again = bootstrap_intervals(blocks_of(1, distances_25), "test", {});
  const MomentIntervals other = bootstrap_intervals(blocks_of(1, distances_25), "test", {.seed = 2});
  EXPECT_EQ(first.kurtosis.high, again.kurtosis.high);
  EXPECT_NE(first.kurtosis.high, other.kurtosis.high);
}

TEST(Bootstrap, CarriesAShiftAndAScaleAlong) {
  std::vector<double> moved;
  for (const double value : distances_25) moved.push_back(1024 + 2 * value);
  const MomentIntervals first = bootstrap_intervals(blocks_of(1, distances_25), "test", {});
  const MomentIntervals second = bootstrap_intervals(blocks_of(1, moved), "test", {});
  EXPECT_NEAR(second.mean.low, 1024 + 2 * first.mean.low, 1e-9);
  EXPECT_NEAR(second.variance.high, 4 * first.variance.high, 1e-9);
  EXPECT_NEAR(second.skewness.low, first.skewness.low, 1e-9);
}

TEST(Bootstrap, SaysNothingOfFewOrEqualValues) {
  EXPECT_EQ(bootstrap_intervals(blocks_of(1, std::vector<double>(7, 1.0)), "test", {}).mean.high, infinity);
  EXPECT_EQ(bootstrap_intervals(blocks_of(1, std::vector<double>(100, 1.0)), "test", {}).mean.high, infinity);
}

TEST(Bootstrap, DrawsWholeBlocks) {
  std::vector<double> opposed;
  for (int i = 0; i < 50; ++i) opposed.insert(opposed.end(), {10.0 + i, 10.0 - i});
  const Interval pairs = bootstrap_intervals(blocks_of(2, opposed), "test", {}).variance;
  EXPECT_LT(pairs.low, moments_of(opposed).variance());
  EXPECT_GT(pairs.high, moments_of(opposed).variance());
  EXPECT_EQ(bootstrap_intervals(blocks_of(20, opposed), "test", {}).mean.high, infinity);  // 5 blocks
}

}  // namespace
}  // namespace slidezone
