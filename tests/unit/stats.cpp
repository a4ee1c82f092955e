// Statistics: moments, and intervals of means, variances, proportions and quantiles.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "stats/interval.hpp"
#include "stats/moments.hpp"
#include "stats_samples.hpp"

namespace slidezone {
namespace {

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
    double hits;
    Interval exact;
    Interval wilson;
  };
  // Ends at which the binomial's tails are 2.5 %, and those of the score equation; given to 10 digits.
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
  for (const double n : {1.0, 7.0, 100000.0}) {
    const double end = -std::expm1(std::log(0.025) / n);
    EXPECT_NEAR(clopper_pearson(0, n).high, end, 1e-12);
    EXPECT_EQ(clopper_pearson(0, n).low, 0);
    EXPECT_NEAR(clopper_pearson(n, n).low, 1 - end, 1e-12);
    EXPECT_EQ(clopper_pearson(n, n).high, 1);
  }
}

TEST(Proportion, SimultaneousBandIsMassarts) {
  const Interval band = simultaneous(500, 1000);  // sqrt(ln 40 / 2000) = 0.042947
  EXPECT_NEAR(band.high, 0.5429469408, 1e-10);
  EXPECT_NEAR(band.low, 0.4570530592, 1e-10);
  EXPECT_EQ(simultaneous(0, 1000).low, 0);
  EXPECT_EQ(simultaneous(1000, 1000).high, 1);
}

TEST(QuantileRanks, MatchReferenceRanks) {
  const auto expect = [](double p, std::optional<std::size_t> low, std::optional<std::size_t> high) {
    const Ranks ranks = quantile_ranks(1000, p, 1000);
    EXPECT_EQ(ranks.low, low) << p;
    EXPECT_EQ(ranks.high, high) << p;
  };
  expect(0.5, 469, 532);
  expect(0.9, 881, 919);
  expect(0.99, 983, 997);
  expect(0.999, 997, std::nullopt);
  EXPECT_FALSE(quantile_ranks(5, 0.5, 5).low);  // 2^-5 = 0.031 > 0.025: five values cannot bound their median
  EXPECT_EQ(quantile_ranks(6, 0.5, 6).low, 1u);
}

TEST(Quantile, IsTheUsualMedianAndStepsElsewhere) {
  EXPECT_EQ(quantile(std::vector<double>{1, 2, 3, 4}, 0.5), 2.5);
  EXPECT_EQ(quantile(std::vector<double>{1, 2, 3}, 0.5), 2);
  EXPECT_EQ(quantile(std::vector<double>{1, 2, 3}, 0.999), 3);
  EXPECT_EQ(quantile(one_to(1000), 1 - 0.1), 900.5);  // 1000 * 0.9 is whole, whatever 1 - 0.1 rounds to
  EXPECT_EQ(quantile(one_to(1000), 1 - 0.001), 999.5);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

}  // namespace
}  // namespace slidezone
