// Random fields: marginal distributions, and the correlation of values.
#include "field/marginal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/vec2.hpp"
#include "field/lognormal.hpp"
#include "field/model.hpp"
#include "field/nataf.hpp"
#include "field/random_fields.hpp"
#include "field_models.hpp"

namespace slidezone {
namespace {

// ---- marginal ----

TEST(Lognormal, HasThePublishedParameters) {
  EXPECT_NEAR(lognormal(20, 0.25).zeta, 0.246220677, 5e-10);  // all digits given
  EXPECT_NEAR(lognormal(20, 0.25).lambda, 2.965419963, 5e-10);
  EXPECT_NEAR(lognormal(20, 0.5).zeta, 0.472380727, 5e-10);
  EXPECT_NEAR(lognormal(20, 0.5).lambda, 2.884160498, 5e-10);
}

TEST(Lognormal, TransformsNormals) {
  std::vector<double> values = {-8, -1, 0, 0.3, 8};
  std::vector<double> transformed = values;
  const Lognormal marginal = lognormal(20e3, 0.5);
  make_lognormal(transformed, marginal);
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_DOUBLE_EQ(transformed[i], std::exp(marginal.lambda + marginal.zeta * values[i])) << values[i];
}

TEST(Lognormal, FloorCountsWhatItRaises) {
  std::vector<double> values = {3, 4, 5, 1, 4};
  EXPECT_EQ(raise_to_floor(values, 4), 2u);
  EXPECT_EQ(values, (std::vector<double>{4, 4, 5, 4, 4}));
}

// ---- other marginals ----

/// Mean and standard deviation of transformed normals, by the trapezoidal rule.
Vec2 moments(const MarginalTransform& transform) {
  double sum = 0, squares = 0;
  for (int i = -8 * 512; i <= 8 * 512; ++i) {
    const double g = i / 512., weight = std::exp(-g * g / 2) / std::sqrt(2 * std::numbers::pi) / 512, value = transform.value(g);
    sum += weight * value;
    squares += weight * value * value;
  }
  return {sum, std::sqrt(squares - sum * sum)};
}

TEST(Marginal, HasTheMeanAndSpreadThatAreGiven) {
  for (const Distribution distribution : {Distribution::lognormal, Distribution::normal, Distribution::beta, Distribution::gamma,
                                          Distribution::weibull, Distribution::uniform})
    for (const double cov : {0.1, 0.4}) {
      const Vec2 found = moments(MarginalTransform(marginal(distribution, cov)));
      EXPECT_NEAR(found.x / 20e3, 1, 1e-9) << distribution_names()[static_cast<std::size_t>(distribution)];
      EXPECT_NEAR(found.y / (20e3 * cov), 1, 1e-7) << distribution_names()[static_cast<std::size_t>(distribution)];
    }
}

TEST(Marginal, TruncatedNormalHasItsMean) {
  const double sd = 8e3, a = (5e3 - 20e3) / sd, b = (60e3 - 20e3) / sd;
  const auto density = [](double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi); };
  const auto below = [](double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; };
  const double mean = 20e3 + sd * (density(a) - density(b)) / (below(b) - below(a));
  EXPECT_NEAR(moments(MarginalTransform(marginal(Distribution::truncated_normal, 0.4))).x, mean, 1e-9 * mean);
  const MarginalTransform transform(marginal(Distribution::truncated_normal, 0.4));
  EXPECT_NEAR(transform.value(-8), 5e3, 1e-3);
  EXPECT_LE(transform.value(8.5), 60e3);
}

TEST(Marginal, EmpiricalFollowsTheData) {
  Marginal data;
  data.distribution = Distribution::empirical;
  data.data = {3, 1, 2, 4};
  const MarginalTransform transform(data);
  EXPECT_DOUBLE_EQ(transform.value(0), 2.5);  // the median
  EXPECT_EQ(transform.value(-5), 1);
  EXPECT_EQ(transform.value(5), 4);
  EXPECT_NEAR(transform.value(-0.31863936396437514), 2, 1e-12);  // the normal's 37.5 % quantile: item 2 of 4
  data.data = {7};
  EXPECT_EQ(MarginalTransform(data).value(1.3), 7);
}

TEST(Marginal, TablesAreAsGoodAsTheQuantiles) {
  for (const Distribution distribution : {Distribution::truncated_normal, Distribution::beta, Distribution::gamma, Distribution::weibull})
    for (const double cov : {0.1, 0.5, 1.0}) {
      Marginal given = marginal(distribution, cov);
      if (distribution == Distribution::beta) given.low = 0, given.high = 200e3;
      const MarginalTransform transform(given);
      std::vector<double> normals;
      for (int i = -6000; i <= 6000; i += 7) normals.push_back(i / 1000.);
      std::vector<double> values = normals;
      transform.apply(values);
      for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(values[i], transform.value(normals[i]), 1e-7 * 20e3 * cov)
            << distribution_names()[static_cast<std::size_t>(distribution)] << " " << cov << " " << normals[i];
    }
}

TEST(Marginal, RepeatedAndExtremeDataHaveTheMiddleOfTheirProbabilities) {
  Marginal data;
  data.distribution = Distribution::empirical;
  data.data = {3, 1, 2, 2, 4};  // items at probabilities of 10, 30, 50, 70, 90 %
  const MarginalTransform transform(data);
  EXPECT_NEAR(transform.normal(1).value(), -1.6448536269514722, 1e-9);  // of 5 %
  EXPECT_NEAR(transform.normal(2).value(), -0.2533471031357997, 1e-9);  // of 40 %
  EXPECT_NEAR(transform.normal(4).value(), 1.6448536269514722, 1e-9);   // of 95 %
  EXPECT_NEAR(transform.normal(3).value(), 0.5244005127080407, 1e-9);   // of 70 %
}

TEST(Marginal, NarrowAndWideOnesAreRightOrRefused) {
  const auto spread = [](Distribution distribution, double cov) {
    return moments(MarginalTransform(marginal(distribution, cov))).y / (20e3 * cov);
  };
  // 1e-6: of the moments, which this rule takes from differences of squares of 1e-4 of the mean.
  EXPECT_NEAR(spread(Distribution::gamma, 0.01), 1, 1e-6);  // where GSL's search fails
  EXPECT_NEAR(spread(Distribution::gamma, 0.02), 1, 1e-6);
  EXPECT_NEAR(spread(Distribution::weibull, 1e-3), 1, 1e-6);
  EXPECT_NEAR(spread(Distribution::weibull, 1e-4), 1, 1e-5);
  EXPECT_NEAR(spread(Distribution::beta, 3e-3), 1, 1e-6);
  for (const auto& [distribution, cov] :
       {std::pair{Distribution::gamma, 1e-3}, {Distribution::weibull, 1e-6}, {Distribution::beta, 1e-4}, {Distribution::beta, 1e-6}})
    EXPECT_THROW(MarginalTransform(marginal(distribution, cov)), Error) << cov;
}

TEST(Marginal, TwoPeaksStayBetweenTheEndsOrAreRefused) {
  Marginal peaks = marginal(Distribution::beta, 0.9);
  peaks.low = 0;
  peaks.high = 40e3;
  std::vector<double> values;
  for (double g = -8.6; g < 8.6; g += 0.001) values.push_back(g);
  MarginalTransform(peaks).apply(values);
  EXPECT_GE(*std::ranges::min_element(values), 0);
  EXPECT_LE(*std::ranges::max_element(values), 40e3);
  peaks.cov = 0.999;  // all but two values: the table is too coarse
  EXPECT_THROW(MarginalTransform{peaks}, Error);
}

TEST(Marginal, RefusesWhatNoDistributionHas) {
  EXPECT_THROW(MarginalTransform(marginal(Distribution::beta, 2)), Error);
  Marginal outside = marginal(Distribution::beta, 0.2);
  outside.mean = 70e3;
  EXPECT_THROW(MarginalTransform{outside}, Error);
}

// ---- correlation of the values ----

TEST(Nataf, HasTheClosedFormsOfLognormalAndUniform) {
  const struct { double cov, gaussian; } published[] = {{0.25, 0.50758}, {0.5, 0.52784}, {1, 0.58496}};
  for (const auto& [cov, gaussian] : published) {
    const Nataf nataf{MarginalTransform(marginal(Distribution::lognormal, cov))};
    EXPECT_NEAR(nataf.gaussian(0.5), gaussian, 5e-6);  // all digits given
    for (const double rho : {-0.2, 0.0, 0.1, 0.9, 1.0})
      EXPECT_NEAR(nataf.gaussian(rho), std::log1p(rho * cov * cov) / std::log1p(cov * cov), 1e-9) << rho;
  }
  const Nataf uniform{MarginalTransform(marginal(Distribution::uniform, 0.3))};
  for (const double r : {-1.0, -0.4, 0.3, 0.8}) EXPECT_NEAR(uniform.physical(r), 6 / std::numbers::pi * std::asin(r / 2), 1e-7) << r;
}

TEST(Nataf, NamesTheFeasibleRange) {
  const Nataf nataf{MarginalTransform(marginal(Distribution::lognormal, 1))};
  EXPECT_NEAR(nataf.physical(-1), -0.5, 1e-9);  // (1/2 - 1)/(2 - 1)
  try {
    nataf.gaussian(-0.6);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a correlation of -0.6 between values of this marginal distribution is infeasible; feasible are -0.5 to 1");
  }
}

TEST(RandomField, ValuesHaveTheCorrelationThatIsGivenForThem) {
  FieldModel wide = model({0.5, 0.5, 6, 1}, Autocorrelation::single_exponential, 3, 1);
  wide.marginal.cov = 0.5;
  wide.correlation_of = CorrelationOf::physical;
  RandomFields field = alone(wide, 0, 5);
  const double n = 20000;
  double products[6] = {};
  std::vector<double> values(6);
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    field.fill(0, values, sample);
    for (std::size_t i = 0; i < 6; ++i) products[i] += (values[0] / 20e3 - 1) / 0.5 * (values[i] / 20e3 - 1) / 0.5;
  }
  // Standard deviation of a product, measured on these samples: below 3.2 (lognormal tails); four standard errors of the mean.
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(products[i] / n, std::exp(-2 * 0.5 * double(i) / 3), 4 * 3.2 / std::sqrt(n)) << i;
}

}  // namespace
}  // namespace slidezone
