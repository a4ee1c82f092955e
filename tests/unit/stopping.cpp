// Statistics: rules that end a study.
#include "stats/stopping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "stats/interval.hpp"
#include "stats/sample.hpp"
#include "stats_samples.hpp"

namespace slidezone {
namespace {

TEST(StopRule, ReadsItsTextBack) {
  for (const char* text : {"paper", "mean=0.25", "sd=0.1", "quantile_0.9=0.5", "exceeds_20=0.02"})
    EXPECT_EQ(to_string(*parse_stop_rule(text)), text);
  EXPECT_EQ(parse_stop_rule("runout_m:mean=1")->quantity, "runout_m");
  for (const char* wrong : {"", "Paper", "mean", "mean=", "mean=0", "mean=-1", "mean=nan", "mean=1m", "reach:mean=1", "quantile_1=1",
                            "quantile_0=1", "quantile_=1", "exceeds_-1=0.1", "exceeds_=0.1", ":mean=1", "runout_m:"})
    EXPECT_FALSE(parse_stop_rule(wrong)) << wrong;
}

TEST(StopRule, LooksAtTheIntervalOfItsTarget) {
  const Sample sample = exactly(one_to(1000));
  EXPECT_DOUBLE_EQ(half_width(*parse_stop_rule("quantile_0.5=1"), sample), (532.0 - 469) / 2);
  EXPECT_NEAR(half_width(*parse_stop_rule("exceeds_990=1"), sample), (0.0183132431 - 0.0048055107) / 2, 1e-10);
  EXPECT_DOUBLE_EQ(half_width(*parse_stop_rule("mean=1"), sample),
                   (mean_estimate(sample).interval.high - mean_estimate(sample).interval.low) / 2);
  const Interval of_sd = root(guarded_variance_estimate(sample)).interval;
  EXPECT_DOUBLE_EQ(half_width(*parse_stop_rule("sd=1"), sample), (of_sd.high - of_sd.low) / 2);
  EXPECT_EQ(half_width(*parse_stop_rule("quantile_0.999=1"), sample), infinity);
  EXPECT_EQ(half_width(*parse_stop_rule("mean=1"), {}), infinity);
}

TEST(NextLook, GrowsByAFifth) {
  EXPECT_EQ(next_look(0, 100), 100u);
  EXPECT_EQ(next_look(100, 100), 120u);
  EXPECT_EQ(next_look(1001, 100), 1202u);
  EXPECT_EQ(next_look(2, 2), 3u);
}

/// Whether any next value at all could meet the paper's rule as the n-th, after n - 1 values of variance 2.24.
bool can_be_met_at(std::size_t n) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < n; ++i) values.push_back((i % 2 == 0 ? 1 : -1) * std::sqrt(2.24));
  values.push_back(0);
  for (double next = 0; next < 3; next += 0.001) {
    values.back() = next;
    if (paper_verdict(values).is_met) return true;
  }
  return false;
}

TEST(PaperRule, IsAMatterOfTheNumberAlone) {
  // A next value d from the mean changes the mean by d / n and the variance by (s^2 - d^2) / n: both < 1e-3 only if
  // n^2 1e-6 + n 1e-3 > s^2, n > 1078 for s^2 = 2.24. Off by a few for n - 1 against n.
  EXPECT_FALSE(can_be_met_at(1070));
  EXPECT_TRUE(can_be_met_at(1086));
}

TEST(PaperRule, RemembersWhenItWasMetFirst) {
  const PaperVerdict verdict = paper_verdict(std::vector<double>{5, 5, 5, 5, 9});
  EXPECT_FALSE(verdict.is_met);
  EXPECT_EQ(verdict.first_met, 3u);
  EXPECT_DOUBLE_EQ(verdict.change_of_mean, 0.8);
  EXPECT_TRUE(std::isnan(paper_verdict(std::vector<double>{5}).change_of_mean));
}

}  // namespace
}  // namespace slidezone
