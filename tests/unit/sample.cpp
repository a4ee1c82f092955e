// Statistics: samples whose runs come in blocks, are censored or unknown.
#include "stats/sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "stats/blocks.hpp"
#include "stats/interval.hpp"
#include "stats/moments.hpp"
#include "stats_samples.hpp"

namespace slidezone {
namespace {

// ---- blocks ----

TEST(Blocks, OfOneAreStudentsAndBonettsAndTheNumberOfRuns) {
  const std::vector<double> values = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8};
  EXPECT_DOUBLE_EQ(mean_interval(blocks_of(1, values)).low, mean_interval(moments_of(values)).low);
  EXPECT_DOUBLE_EQ(mean_interval(blocks_of(1, values)).high, mean_interval(moments_of(values)).high);
  EXPECT_EQ(effective_count(blocks_of(1, {1, 0, 0, 1})), 4);
  // Bonett's with Student's t for z and the kurtosis about the mean: c s^2 exp(-t c sqrt((k - 9 / 12) / 11)) with t = 2.20099, c = 12 / (12
  // - t).
  const double t = 2.2009851600916384, c = 12 / (12 - t);
  const Moments moments = moments_of(values);
  EXPECT_NEAR(variance_interval(blocks_of(1, values), 0).low,
              c * moments.variance() * std::exp(-t * c * std::sqrt((moments.kurtosis() - 0.75) / 11)), 1e-9);
}

TEST(Blocks, MeanIsThatOfBlockMeans) {
  // Means 2, 4, 9 of pairs: 5 +- t_2 sqrt(13 / 3), t_2 = 4.30265.
  const Interval interval = mean_interval(blocks_of(2, {1, 3, 6, 2, 10, 8}));
  EXPECT_NEAR(interval.low, 5 - 4.302652729911275 * std::sqrt(13.0 / 3), 1e-9);
  EXPECT_NEAR(interval.high, 5 + 4.302652729911275 * std::sqrt(13.0 / 3), 1e-9);
}

TEST(Blocks, PairsWhoseMeansAreEqualTellTheMeanExactly) {
  const Interval interval = mean_interval(blocks_of(2, {1, 9, 4, 6, 3, 7}));
  EXPECT_NEAR(interval.low, 5, 1e-12);
  EXPECT_NEAR(interval.high, 5, 1e-12);
}

TEST(Blocks, AnIncompleteBlockCountsByItsRuns) {
  // Sums less 5 times the count: -4, 0, 4 and n = 5: half-width t_2 sqrt(3 / 2 * 32) / 5.
  const Interval interval = mean_interval(Blocks{{1}, {4, 6}, {7, 7}});
  EXPECT_NEAR(interval.high, 5 + 4.302652729911275 * std::sqrt(48.0) / 5, 1e-9);
}

TEST(Blocks, OneAloneTellsNothing) {
  EXPECT_EQ(mean_interval(blocks_of(4, {1, 2, 3, 4})).high, infinity);
  EXPECT_EQ(variance_interval(blocks_of(4, {1, 2, 3, 4}), 0).high, infinity);
  EXPECT_EQ(effective_count(blocks_of(4, {1, 0, 1, 0})), 0);
}

TEST(Blocks, ProportionsCountAtMostTheRunsAndWithoutAHitTheBlocksOfPairs) {
  const std::vector<double> none(200, 0.0);
  EXPECT_DOUBLE_EQ(effective_count(blocks_of(1, none)), 200);
  // Pairs: effect 2, t_199 = 1.97196 and t_99 = 1.98422.
  EXPECT_NEAR(effective_count(blocks_of(2, none)), 100 * std::pow(1.971956544249388 / 1.984216951586283, 2), 1e-6);
  std::vector<double> opposed, alike;
  for (int i = 0; i < 100; ++i) {
    opposed.insert(opposed.end(), {0.0, 1.0});
    alike.insert(alike.end(), 2, i % 2);
  }
  EXPECT_EQ(effective_count(blocks_of(2, opposed)), 200);
  EXPECT_NEAR(effective_count(blocks_of(2, alike)), 100 * 0.99 * std::pow(1.971956544249388 / 1.984216951586283, 2), 1e-6);
}

TEST(Blocks, AWidenedVarianceAllowsForALongerTail) {
  const std::vector<double> values = one_to(100);
  EXPECT_GT(variance_interval(blocks_of(1, values), 2).high, variance_interval(blocks_of(1, values), 0).high);
  EXPECT_LT(variance_interval(blocks_of(1, values), 2).low, variance_interval(blocks_of(1, values), 0).low);
}

TEST(QuantileRanks, OfFewerIndependentValuesLieFartherApart) {
  // 1000 values worth 250: ranks 109 and 142 of 250 (0.5), times 4, outward to whole ranks.
  const Ranks few = quantile_ranks(250, 0.5, 250);
  const Ranks many = quantile_ranks(1000, 0.5, 250);
  EXPECT_NEAR(static_cast<double>(*many.low), 4.0 * static_cast<double>(*few.low), 4);
  EXPECT_NEAR(static_cast<double>(*many.high), 4.0 * static_cast<double>(*few.high), 4);
  EXPECT_FALSE(quantile_ranks(1000, 0.5, 0).low);
}

TEST(Sample, OfBlocksKnowsThem) {
  const Sample sample = {{1, Knowledge::exact, 7}, {2, Knowledge::exact, 8}, {3, Knowledge::exact, 7}, {0, Knowledge::unknown, 8}};
  EXPECT_TRUE(has_blocks(sample));
  EXPECT_EQ(known_blocks(sample), (Blocks{{1, 3}, {2}}));
  EXPECT_EQ(known_blocks(exactly({1, 2})), (Blocks{{1}, {2}}));
  EXPECT_FALSE(has_blocks(exactly({1, 2})));
}

// ---- samples with censored and unknown values ----

TEST(Sample, WithoutDoubtIsTheClassicalCase) {
  const Sample sample = exactly(one_to(1000));
  const Estimate exceedance = exceedance_estimate(sample, 990);
  EXPECT_DOUBLE_EQ(exceedance.value, 0.01);
  EXPECT_NEAR(exceedance.interval.low, 0.0048055107, 1e-10);
  EXPECT_NEAR(exceedance.interval.high, 0.0183132431, 1e-10);
  EXPECT_EQ(exceedance_estimate(sample, 1000).value, 0);  // strictly beyond
  EXPECT_EQ(quantile_estimate(sample, 0.99).interval.low, 983);
  EXPECT_EQ(quantile_estimate(sample, 0.99).interval.high, 997);
}

TEST(Sample, CensoredValuesExceedUpToTheirBoundAndOpenTheUpperEnd) {
  Sample sample = exactly(one_to(1000));
  sample[995].knowledge = Knowledge::at_least;  // the value 996
  EXPECT_DOUBLE_EQ(exceedance_estimate(sample, 990).value, 0.01);
  const Estimate beyond = exceedance_estimate(sample, 998);  // 999 and 1000, perhaps 996
  EXPECT_DOUBLE_EQ(beyond.value, 2.0 / 999);
  EXPECT_DOUBLE_EQ(beyond.interval.low, clopper_pearson(2, 1000).low);
  EXPECT_DOUBLE_EQ(beyond.interval.high, clopper_pearson(3, 1000).high);
  EXPECT_EQ(quantile_estimate(sample, 0.99).interval.high, 998);  // the censored run may be the farthest
  EXPECT_EQ(mean_estimate(sample).interval.high, infinity);
  EXPECT_EQ(variance_estimate(sample).interval.high, infinity);
  EXPECT_EQ(mean_estimate(sample).interval.low, mean_estimate(exactly(one_to(1000))).interval.low);
}

TEST(Sample, UnknownValuesWidenBothEnds) {
  Sample sample = exactly(one_to(999));
  sample.push_back({std::numeric_limits<double>::quiet_NaN(), Knowledge::unknown});
  const Estimate exceedance = exceedance_estimate(sample, 990);
  EXPECT_DOUBLE_EQ(exceedance.value, 9.0 / 999);
  EXPECT_DOUBLE_EQ(exceedance.interval.low, clopper_pearson(9, 1000).low);
  EXPECT_DOUBLE_EQ(exceedance.interval.high, clopper_pearson(10, 1000).high);
  EXPECT_EQ(quantile_estimate(sample, 0.5).interval.low, 468);   // rank 469 with the unknown value below all
  EXPECT_EQ(quantile_estimate(sample, 0.5).interval.high, 532);  // rank 532 with it above all
  EXPECT_EQ(mean_estimate(sample).value, 500);
}

TEST(Sample, OfUnknownValuesSaysNothing) {
  const Sample sample(3, {0, Knowledge::unknown});
  const Estimate exceedance = exceedance_estimate(sample, 1);
  EXPECT_TRUE(std::isnan(exceedance.value));
  EXPECT_EQ(exceedance.interval.low, 0);
  EXPECT_EQ(exceedance.interval.high, 1);
  EXPECT_TRUE(std::isnan(mean_estimate(sample).value));
}

}  // namespace
}  // namespace slidezone
