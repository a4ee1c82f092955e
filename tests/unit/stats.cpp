#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "stats/distribution.hpp"
#include "stats/interval.hpp"
#include "stats/moments.hpp"
#include "stats/sample.hpp"
#include "stats/stopping.hpp"

namespace slidezone {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Values of a NIST data set: one a line after a header that ends in a line of dashes.
std::vector<double> nist_values(const std::string& name) {
  std::ifstream file(std::string(TEST_DATA) + "/nist/" + name + ".dat");
  std::string line;
  while (std::getline(file, line) && !line.starts_with("-----")) {
  }
  std::vector<double> values;
  for (double value = 0; file >> value;) values.push_back(value);
  return values;
}

std::vector<double> one_to(std::size_t count) {
  std::vector<double> values(count);
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

Sample exactly(const std::vector<double>& values) {
  Sample sample;
  for (const double value : values) sample.push_back({value, Knowledge::exact});
  return sample;
}

// ---- moments ----

struct Certified {
  const char* name;
  std::size_t count;
  double mean;
  double sd;
};

class Nist : public testing::TestWithParam<Certified> {};

TEST_P(Nist, MatchesTheCertifiedValues) {
  const Certified& certified = GetParam();
  const Moments moments = moments_of(nist_values(certified.name));
  ASSERT_EQ(moments.count(), certified.count);
  // Certified to 15 digits; double input and one rounding per value leave 14.
  EXPECT_NEAR(moments.mean(), certified.mean, 1e-14 * std::abs(certified.mean));
  EXPECT_NEAR(moments.standard_deviation(), certified.sd, 1e-14 * certified.sd);
}

INSTANTIATE_TEST_SUITE_P(CertifiedSets, Nist,
                         testing::Values(Certified{"Lottery", 218, 518.958715596330, 291.699727470969},
                                         Certified{"Lew", 200, -177.4350000000000, 277.332168044316}, Certified{"NumAcc1", 3, 10000002, 1}),
                         [](const auto& set) { return set.param.name; });

TEST(Moments, MatchMichelsonToTheDigitsOfItsInput) {
  const Moments moments = moments_of(nist_values("Michelso"));
  ASSERT_EQ(moments.count(), 100u);
  EXPECT_NEAR(moments.mean(), 299.8524, 299.8524 * 1e-15);
  // 299.85 is not a double: its rounding of up to 3e-14 over a sd of 0.08 leaves 12 to 13 digits.
  EXPECT_NEAR(moments.standard_deviation(), 0.0790105478190518, 0.079 * 1e-12);
}

/// NIST's NumAcc3 and NumAcc4: 1001 values offset + 0.2, then 0.1 and 0.3 in turn; mean offset + 0.2, sd 0.1 exactly.
double sd_of_offset_series(double offset) {
  Moments moments;
  moments.add(offset + 0.2);
  for (int i = 0; i < 500; ++i) {
    moments.add(offset + 0.1);
    moments.add(offset + 0.3);
  }
  return moments.standard_deviation();
}

TEST(Moments, LoseNothingToALargeOffset) {
  // What is left is the rounding of the input: half a unit in the last place of 1000000.1 is 6e-11, of 10000000.1 9e-10.
  EXPECT_NEAR(sd_of_offset_series(1e6), 0.1, 6e-11);
  EXPECT_NEAR(sd_of_offset_series(1e7), 0.1, 1e-9);
}

TEST(Moments, SkewnessAndKurtosisOfSmallSets) {
  const Moments even = moments_of(std::vector<double>{-1, 1, -1, 1});
  EXPECT_DOUBLE_EQ(even.skewness(), 0);
  EXPECT_DOUBLE_EQ(even.kurtosis(), 1);
  // 0, 0, 0, 4: mean 1, central moments 3, 6, 21.
  const Moments lone = moments_of(std::vector<double>{0, 0, 0, 4});
  EXPECT_NEAR(lone.skewness(), 6 / std::pow(3, 1.5), 1e-15);
  EXPECT_NEAR(lone.kurtosis(), 21.0 / 9, 1e-15);
}

TEST(Moments, AreNanWhereValuesAreTooFew) {
  EXPECT_TRUE(std::isnan(moments_of({}).mean()));
  EXPECT_TRUE(std::isnan(moments_of(std::vector<double>{1}).variance()));
  EXPECT_TRUE(std::isnan(moments_of(std::vector<double>{1, 1}).skewness()));
}

// ---- intervals ----

TEST(MeanInterval, IsStudents) {
  // Michelson: t(0.975, 99) = 1.98421695158642, over sqrt(100).
  const Interval interval = mean_interval(moments_of(nist_values("Michelso")));
  EXPECT_NEAR(interval.high - 299.8524, 0.198421695158642 * 0.0790105478190518, 1e-12);
  EXPECT_NEAR(299.8524 - interval.low, 0.198421695158642 * 0.0790105478190518, 1e-12);
}

TEST(MeanInterval, IsUnboundedForOneValueAndForEqualOnes) {
  EXPECT_EQ(mean_interval(moments_of(std::vector<double>{3})).high, infinity);
  EXPECT_EQ(mean_interval(moments_of(std::vector<double>{3, 3, 3})).low, -infinity);
}

TEST(VarianceInterval, KnowsTheKurtosis) {
  // Two-valued: kurtosis about the centre is 1, the least there is: (1 - (n - 3) / n) / (n - 1) = 3 / (n (n - 1)).
  std::vector<double> values;
  for (int i = 0; i < 50; ++i) values.insert(values.end(), {-1, 1});
  const double c = 100 / (100 - 1.959963984540054);
  const Interval interval = variance_interval(values);
  const double half_width = 1.959963984540054 * c * std::sqrt((1.0 - 97.0 / 100) / 99);
  EXPECT_NEAR(interval.low, c * 100 / 99 * std::exp(-half_width), 1e-12);
  EXPECT_NEAR(interval.high, c * 100 / 99 * std::exp(half_width), 1e-12);
  EXPECT_EQ(variance_interval(std::vector<double>{1, 2, 3, 4}).high, infinity);
  EXPECT_EQ(variance_interval(std::vector<double>(9, 1.0)).high, infinity);
}

TEST(Proportion, MatchesReferenceIntervals) {
  struct Reference {
    std::size_t hits;
    Interval exact;
    Interval wilson;
  };
  // From PHYSICS.md's independent computation; given to 10 digits.
  const Reference references[] = {{0, {0, 0.0036820839}, {0, 0.0038267585}},
                                  {10, {0.0048055107, 0.0183132431}, {0.0054407544, 0.0183094689}},
                                  {500, {0.4685491730, 0.5314508270}, {0.4690696004, 0.5309303996}}};
  for (const Reference& reference : references) {
    const Interval exact = clopper_pearson(reference.hits, 1000);
    const Interval score = wilson(reference.hits, 1000);
    EXPECT_NEAR(exact.low, reference.exact.low, 1e-10) << reference.hits;
    EXPECT_NEAR(exact.high, reference.exact.high, 1e-10) << reference.hits;
    EXPECT_NEAR(score.low, reference.wilson.low, 1e-10) << reference.hits;
    EXPECT_NEAR(score.high, reference.wilson.high, 1e-10) << reference.hits;
  }
}

TEST(Proportion, IsExactAtTheEnds) {
  // Closed form: 0 of n has the upper end 1 - 0.025^(1/n); n of n mirrors it.
  for (const std::size_t n : {1u, 7u, 100000u}) {
    const double end = -std::expm1(std::log(0.025) / static_cast<double>(n));
    EXPECT_NEAR(clopper_pearson(0, n).high, end, 1e-12);
    EXPECT_EQ(clopper_pearson(0, n).low, 0);
    EXPECT_NEAR(clopper_pearson(n, n).low, 1 - end, 1e-12);
    EXPECT_EQ(clopper_pearson(n, n).high, 1);
  }
}

TEST(QuantileRanks, MatchReferenceRanks) {
  const auto expect = [](double p, std::optional<std::size_t> low, std::optional<std::size_t> high) {
    const Ranks ranks = quantile_ranks(1000, p);
    EXPECT_EQ(ranks.low, low) << p;
    EXPECT_EQ(ranks.high, high) << p;
  };
  expect(0.5, 469, 532);
  expect(0.9, 881, 919);
  expect(0.99, 983, 997);
  expect(0.999, 997, std::nullopt);
  EXPECT_FALSE(quantile_ranks(5, 0.5).low);  // 2^-5 = 0.031 > 0.025: five values cannot bound their median
  EXPECT_EQ(quantile_ranks(6, 0.5).low, 1u);
}

TEST(Quantile, IsTheUsualMedianAndStepsElsewhere) {
  EXPECT_EQ(quantile(std::vector<double>{1, 2, 3, 4}, 0.5), 2.5);
  EXPECT_EQ(quantile(std::vector<double>{1, 2, 3}, 0.5), 2);
  EXPECT_EQ(quantile(std::vector<double>{1, 2, 3}, 0.999), 3);
  EXPECT_EQ(quantile(one_to(1000), 1 - 0.1), 900.5);  // 1000 * 0.9 is whole, whatever 1 - 0.1 rounds to
  EXPECT_EQ(quantile(one_to(1000), 1 - 0.001), 999.5);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
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

// ---- distributions ----

TEST(Fit, RecoversMeanAndSdOfTheLogarithm) {
  const std::vector<double> values = {std::exp(1.0), std::exp(2.0), std::exp(3.0)};
  const auto fit = fit_of(Family::lognormal, values);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->parameters[0], 2, 1e-15);
  EXPECT_NEAR(fit->parameters[1], 1, 1e-15);
  EXPECT_NEAR(tail(*fit, std::exp(2.0)), 0.5, 1e-15);
  EXPECT_NEAR(cumulative(*fit, std::exp(3.0)), 0.841344746068543, 1e-15);  // Phi(1)
  EXPECT_EQ(cumulative(*fit, -1), 0);
  EXPECT_EQ(tail(*fit, 0), 1);
}

TEST(Fit, IsRefusedWhereThereIsNone) {
  EXPECT_FALSE(fit_of(Family::lognormal, std::vector<double>{0, 1, 2}));
  EXPECT_FALSE(fit_of(Family::normal, std::vector<double>{1, 1}));
  EXPECT_FALSE(fit_of(Family::normal, std::vector<double>{1}));
}

TEST(ChiSquare, IsZeroForValuesSpreadAsTheFit) {
  // 120 values at the middles of 120 equal probabilities of the fit.
  const Fit fit{Family::lognormal, {0, 1}};
  std::vector<double> values;
  for (int i = 0; i < 120; ++i) {
    double low = -10, high = 10;  // bisection of the cumulative in ln x
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      (cumulative(fit, std::exp(middle)) < (i + 0.5) / 120 ? low : high) = middle;
    }
    values.push_back(std::exp(low));
  }
  const auto test = chi_square(fit, values);  // 2 * 120^0.4 = 13.6
  ASSERT_TRUE(test);
  EXPECT_EQ(test->bins, 13u);
  EXPECT_EQ(test->degrees_of_freedom, 10u);
  EXPECT_LT(test->statistic, 0.84);  // bins of 9 and 10 for 9.23 expected: at most 13 * 0.77^2 / 9.23
  EXPECT_GT(test->p, 0.999);         // 10 degrees of freedom exceed 0.84 with probability 0.9999
}

TEST(ChiSquare, SeesTwoHeapsAndWantsTwentyValues) {
  std::vector<double> heaps;
  for (int i = 0; i < 100; ++i) heaps.push_back((i % 2 == 0 ? 7 : 11) + 0.001 * i);
  EXPECT_LT(chi_square(*fit_of(Family::normal, heaps), heaps)->p, 1e-9);
  EXPECT_FALSE(chi_square(Fit{}, one_to(19)));
  EXPECT_TRUE(chi_square(Fit{}, one_to(20)));
}

// ---- stopping ----

TEST(StopRule, ReadsItsTextBack) {
  for (const char* text : {"paper", "mean=0.25"}) EXPECT_EQ(to_string(*parse_stop_rule(text)), text);
  for (const char* wrong : {"", "Paper", "mean", "mean=", "mean=0", "mean=-1", "mean=nan", "mean=1m", "sd=1"})
    EXPECT_FALSE(parse_stop_rule(wrong)) << wrong;
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
