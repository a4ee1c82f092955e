// Random fields: samples of one and of several parameters, with trends and correlations.
#include "field/random_fields.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "field/cell_transform.hpp"
#include "field/conditioning.hpp"
#include "field/cross_correlation.hpp"
#include "field/marginal.hpp"
#include "field/mesh_covariance.hpp"
#include "field/model.hpp"
#include "field/nataf.hpp"
#include "field_models.hpp"

namespace slidezone {
namespace {

// ---- samples ----

/// The benchmark's field with a COV of 0.5, so that the floor matters.
FieldModel benchmark() {
  FieldModel benchmark = model({0.1, 0.1, 250, 50}, Autocorrelation::single_exponential, 1, 1);
  benchmark.marginal.cov = 0.5;
  return benchmark;
}

TEST(RandomField, HasMeanCovAndFloorsOfItsModel) {
  // 400 samples of 25 m x 5 m: the mean over one has variance sd^2 times the product of the variance functions of its
  // sides; the lognormal's correlation is below the Gaussian's, which serves as a bound.
  const auto variance_function = [](double scales) { return (2 * scales + std::expm1(-2 * scales)) / (2 * scales * scales); };
  const double n = 400, reduction = variance_function(25) * variance_function(5);
  double sum = 0, squares = 0, floored = 0;
  RandomFields field = alone(benchmark(), 4e3, 1);
  std::vector<double> values(12500);
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    floored += double(field.fill(0, values, sample));
    for (const double value : values) sum += value, squares += value * value;
  }
  const double cells = n * 12500;
  const double mean = sum / cells, cov = std::sqrt(squares / cells - mean * mean) / mean;
  EXPECT_NEAR(mean / 20e3, 1, 4 * 0.5 * std::sqrt(reduction / n));
  // Standard deviations over 40 seeds: 0.2 % of the COV, 3.4 % of the floored count (floored cells come in clusters).
  EXPECT_NEAR(cov / 0.5, 1, 4 * 0.002);
  EXPECT_NEAR(floored / cells / 7.6e-4, 1, 4 * 0.034);
}

TEST(RandomField, SamplesDoNotDependOnEachOther) {
  RandomFields field = alone(benchmark(), 4e3, 7);
  std::vector<double> single(12500), among(12500);
  for (std::uint32_t sample = 1; sample <= 3; ++sample) field.fill(0, among, sample);
  field.fill(0, single, 3);
  EXPECT_EQ(single, among);
  field.fill(0, among, 4);
  EXPECT_NE(single, among);
}

// ---- trends ----

TEST(Trend, ChangesTheMeanAndKeepsCovOrSd) {
  FieldModel deep = model({1, 1, 1, 3}, Autocorrelation::single_exponential, 3, 1);
  deep.trend = {2e3, Spread::constant_cov, {5, 2.5, 0}};  // mean 30, 25, 20 kPa
  for (const Spread spread : {Spread::constant_cov, Spread::constant_sd}) {
    deep.trend.spread = spread;
    const CellTransform transform(deep);
    RandomFields field = alone(deep, 0, 2);
    const double n = 20000;
    double sums[3] = {}, squares[3] = {};
    std::vector<double> values(3);
    for (std::uint32_t sample = 1; sample <= n; ++sample) {
      field.fill(0, values, sample);
      for (std::size_t cell = 0; cell < 3; ++cell) sums[cell] += values[cell], squares[cell] += values[cell] * values[cell];
    }
    for (std::size_t cell = 0; cell < 3; ++cell) {
      const double mean = 20e3 + 2e3 * deep.trend.depth[cell], sd = spread == Spread::constant_cov ? 0.25 * mean : 5e3;
      const double found = sums[cell] / n;
      // Four standard errors; the kurtosis of this lognormal is 4.1: that of a standard deviation is sqrt((4.1 - 1) / 4 n) of it.
      EXPECT_NEAR(found, mean, 4 * sd / std::sqrt(n)) << cell;
      EXPECT_NEAR(std::sqrt(squares[cell] / n - found * found) / sd, 1, 4 * std::sqrt(3.1 / 4 / n)) << cell;
      EXPECT_NEAR(transform.normal(transform.with_trend(transform.marginal().value(0.7), cell), cell).value(), 0.7, 1e-12);
      EXPECT_NEAR(transform.slope(0.7, cell),
                  (transform.with_trend(transform.marginal().value(0.7001), cell) -
                   transform.with_trend(transform.marginal().value(0.6999), cell)) /
                      2e-4,
                  1e-2);
    }
  }
}

// ---- several fields ----

/// Two fields of one model and a third apart, the first two correlated.
RandomFields pair_of_fields(const FieldModel& first, const Marginal& second, double correlation, CorrelationOf of,
                            std::vector<Measurement> of_first = {}) {
  FieldModel other = first;
  other.marginal = second;
  return RandomFields({{"cohesion", first, {}, false, std::move(of_first)},
                       {"youngs_modulus", first, {}, false, {}},
                       {"friction_angle", other, {}, false, {}}},
                      {{{0, 2}, {{1, correlation}, {correlation, 1}}, of}}, 4);
}

TEST(CrossCorrelation, HoldsAtAPointAndFallsWithTheLag) {
  FieldModel normal = model(strip, Autocorrelation::second_order_markov, 3, 1);
  normal.marginal.distribution = Distribution::normal;
  normal.correlation.nugget = 0.1;
  RandomFields fields = pair_of_fields(normal, normal.marginal, -0.6, CorrelationOf::gaussian);
  const Eigen::MatrixXd own = 0.9 * full_covariance(normal) + 0.1 * Eigen::MatrixXd::Identity(36, 36);
  const double n = 5000;
  const Eigen::Index cells[] = {0, 1, 9, 20, 35};
  Eigen::MatrixXd within = Eigen::MatrixXd::Zero(36, 36), across = within, apart = within;
  std::vector<double> a(36), b(36), c(36);
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    fields.fill(0, a, sample);
    fields.fill(1, b, sample);
    fields.fill(2, c, sample);
    const auto g = [](const std::vector<double>& values, Eigen::Index i) { return (values[std::size_t(i)] / 20e3 - 1) / 0.25; };
    for (const Eigen::Index i : cells)
      for (const Eigen::Index j : cells) {
        within(i, j) += g(c, i) * g(c, j) / n;
        across(i, j) += g(a, i) * g(c, j) / n;
        apart(i, j) += g(b, i) * g(c, j) / n;
      }
  }
  // 75 products of standard error sqrt((1 + rho^2) / n): within 4.5 of them, which a right sampler misses once in 2000 seeds.
  for (const Eigen::Index i : cells)
    for (const Eigen::Index j : cells) {
      const double rho = own(i, j);
      EXPECT_NEAR(within(i, j), rho, 4.5 * std::sqrt((1 + rho * rho) / n));
      EXPECT_NEAR(across(i, j), -0.6 * rho, 4.5 * std::sqrt((1 + 0.36 * rho * rho) / n));
      EXPECT_NEAR(apart(i, j), 0, 4.5 / std::sqrt(n));
    }
}

TEST(CrossCorrelation, LeavesTheFirstFieldAsItIsAlone) {
  const FieldModel plain = model(strip, Autocorrelation::single_exponential, 3, 1);
  RandomFields fields = pair_of_fields(plain, plain.marginal, 0.5, CorrelationOf::gaussian);
  RandomFields single = alone(plain, 0, 4);
  std::vector<double> among(36), by_itself(36);
  fields.fill(0, among, 3);
  single.fill(0, by_itself, 3);
  EXPECT_EQ(among, by_itself);
}

TEST(CrossCorrelation, OfValuesIsMadeByNataf) {
  const Nataf cohesion{MarginalTransform(marginal(Distribution::lognormal, 0.3))},
      friction{MarginalTransform(marginal(Distribution::lognormal, 0.2))};
  EXPECT_NEAR(gaussian_correlation(cohesion, friction, -0.5), -0.523918116522, 1e-11);  // all digits given
  EXPECT_NEAR(physical_correlation(cohesion, friction, -0.523918116522), -0.5, 1e-11);
  const Nataf uniform{MarginalTransform(marginal(Distribution::uniform, 0.3))};
  EXPECT_NEAR(gaussian_correlation(uniform, uniform, 0.3), uniform.gaussian(0.3), 1e-12);
  EXPECT_EQ(gaussian_correlation(uniform, cohesion, 0), 0);

  FieldModel wide = model({1, 1, 1, 1}, Autocorrelation::single_exponential, 3, 1);
  wide.marginal.cov = 0.3;
  RandomFields fields = pair_of_fields(wide, marginal(Distribution::lognormal, 0.2), -0.5, CorrelationOf::physical);
  const double n = 50000;
  double sum = 0;
  std::vector<double> a(1), b(1);
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    fields.fill(0, a, sample);
    fields.fill(2, b, sample);
    sum += (a[0] / 20e3 - 1) / 0.3 * (b[0] / 20e3 - 1) / 0.2;
  }
  EXPECT_NEAR(sum / n, -0.5, 4 * 1.11 / std::sqrt(n));  // standard deviation of the product, measured on 400,000 others
}

TEST(CrossCorrelation, ConditionsTheOthersToo) {
  // Simple cokriging written out: one exact value of the first field tells of the second by the cross-correlation.
  FieldModel normal = model(strip, Autocorrelation::single_exponential, 3, 1);
  normal.marginal.distribution = Distribution::normal;
  RandomFields fields = pair_of_fields(normal, normal.marginal, -0.6, CorrelationOf::gaussian, {{3, 30e3, 0, "a"}});  // two deviations up
  const Eigen::VectorXd to = full_covariance(normal).col(3);
  const double n = 20000;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(36), squares = sum;
  std::vector<double> first(36), second(36);
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    fields.fill(0, first, sample);
    fields.fill(2, second, sample);
    EXPECT_NEAR(first[3], 30e3, 1e-6);
    for (Eigen::Index i = 0; i < 36; ++i) {
      const double g = (second[std::size_t(i)] / 20e3 - 1) / 0.25 - 2 * -0.6 * to(i);
      sum(i) += g / n;
      squares(i) += g * g / n;
    }
  }
  for (Eigen::Index i = 0; i < 36; ++i) {
    const double variance = 1 - std::pow(0.6 * to(i), 2);
    EXPECT_NEAR(sum(i), 0, 4 * std::sqrt(variance / n)) << i;
    EXPECT_NEAR(squares(i), variance, 4 * variance * std::sqrt(2 / n)) << i;
  }
}

TEST(CrossCorrelation, RefusesWhatContradictsItself) {
  EXPECT_EQ(flaw_of_correlations({{1, 0.5}, {0.5, 1}}), "");
  EXPECT_EQ(flaw_of_correlations({{1, 0.9, -0.9}, {0.9, 1, 0.9}, {-0.9, 0.9, 1}}),
            "is not positive definite: its least eigenvalue is -0.8, so these correlations contradict each other; all of them times 0.55 "
            "would do");
  EXPECT_NE(flaw_of_correlations({{1, 1}, {1, 1}}), "");
  const auto message = [](const Marginal& second, double rho) -> std::string {
    try {
      pair_of_fields(model(strip, Autocorrelation::single_exponential, 3, 1), second, rho, CorrelationOf::physical);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(marginal(Distribution::lognormal, 2), -0.9),
            "[field.cohesion, friction_angle]: row 2, column 1 of the matrix: a correlation of -0.9 between values of these two marginal "
            "distributions is infeasible; feasible are -0.5366 to 0.7333");  // (exp(-+z_1 z_2) - 1) / (cov_1 cov_2), z = .2462, 1.2686
}

TEST(RandomFields, RefuseModelsThatMayFallToZero) {
  const auto draw = [](const Marginal& marginal) {
    FieldModel stiffness = model(strip, Autocorrelation::single_exponential, 3, 1);
    stiffness.marginal = marginal;
    return RandomFields({{"youngs_modulus", stiffness, {}, true, {}}}, {}, 1);
  };
  EXPECT_NO_THROW(draw(marginal(Distribution::normal, 0.11)));
  EXPECT_NO_THROW(draw(marginal(Distribution::lognormal, 1)));
  EXPECT_THROW(draw(marginal(Distribution::normal, 0.12)), Error);  // 1 / 8.6 = 0.116
}

TEST(RandomFields, CountWhatTheyMoveToEitherLimit) {
  RandomFields field({{"friction_angle", benchmark(), {.low = 19e3, .high = 21e3}, false, {}}}, {}, 1);
  std::vector<double> values(12500);
  const std::size_t moved = field.fill(0, values, 1);
  EXPECT_EQ(moved, std::size_t(std::ranges::count(values, 19e3) + std::ranges::count(values, 21e3)));
  EXPECT_EQ(*std::ranges::max_element(values), 21e3);
  EXPECT_EQ(*std::ranges::min_element(values), 19e3);
}

}  // namespace
}  // namespace slidezone
