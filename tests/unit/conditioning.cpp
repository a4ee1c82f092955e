// Random fields that honour measurements.
#include "field/conditioning.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "field/mesh_covariance.hpp"
#include "field/model.hpp"
#include "field/random_fields.hpp"
#include "field_models.hpp"

namespace slidezone {
namespace {

// ---- conditioning ----

TEST(Conditioning, MeetsExactMeasurements) {
  for (const Method method : {Method::separable, Method::circulant, Method::cholesky}) {
    FieldModel conditioned = with_method(model(strip, Autocorrelation::second_order_markov, 3, 1), method);
    conditioned.correlation.nugget = 0.2;
    RandomFields field = alone(conditioned, 0, 1, {{3, 25e3, 0, "a"}, {30, 14e3, 0, "b"}, {30, 14e3, 0, "c"}});
    std::vector<double> values(36);
    for (std::uint32_t sample = 1; sample <= 5; ++sample) {
      field.fill(0, values, sample);
      EXPECT_NEAR(values[3], 25e3, 1e-6);  // 1e-10 of the value
      EXPECT_NEAR(values[30], 14e3, 1e-6);
      EXPECT_GT(std::abs(values[10] - values[12]), 1);
    }
  }
}

TEST(Conditioning, EnsembleHasMeanAndVarianceOfSimpleKriging) {
  FieldModel conditioned = model(strip, Autocorrelation::single_exponential, 3, 1);
  conditioned.correlation.nugget = 0.1;
  conditioned.marginal.distribution = Distribution::normal;
  const double sd = 5e3, error = 2e3;
  const std::vector<Measurement> measurements = {{3, 25e3, 0, "a"}, {30, 14e3, error, "b"}, {30, 17e3, error, "c"}};
  RandomFields field = alone(conditioned, -1e9, 1, measurements);
  // Simple kriging written out for this case: covariances of the values, in units of their variance.
  const Eigen::MatrixXd prior = 0.9 * full_covariance(conditioned) + 0.1 * Eigen::MatrixXd::Identity(36, 36);
  const Eigen::Index at[] = {3, 30, 30};
  Eigen::MatrixXd between(3, 3), to(36, 3);
  Eigen::Vector3d data;
  for (int i = 0; i < 3; ++i) {
    data(i) = (measurements[std::size_t(i)].value - 20e3) / sd;
    to.col(i) = prior.col(at[i]);
    for (int j = 0; j < 3; ++j) between(i, j) = prior(at[i], at[j]) + (i == j ? std::pow(measurements[std::size_t(i)].error / sd, 2) : 0);
  }
  const Eigen::MatrixXd weights = to * between.inverse();
  const Eigen::VectorXd mean = weights * data;
  const Eigen::VectorXd variance = (prior - weights * to.transpose()).diagonal();

  const double n = 20000;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(36), squares = Eigen::VectorXd::Zero(36);
  std::vector<double> values(36);
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    field.fill(0, values, sample);
    for (Eigen::Index i = 0; i < 36; ++i) {
      const double g = (values[std::size_t(i)] - 20e3) / sd;
      sum(i) += g;
      squares(i) += (g - mean(i)) * (g - mean(i));
    }
  }
  for (Eigen::Index i = 0; i < 36; ++i) {
    EXPECT_NEAR(sum(i) / n, mean(i), 4 * std::sqrt(variance(i) / n) + 1e-12) << i;
    EXPECT_NEAR(squares(i) / n, variance(i), 4 * variance(i) * std::sqrt(2 / n) + 1e-12) << i;
  }
}

TEST(Conditioning, RefusesWhatCannotBeMet) {
  const FieldModel plain = model(strip, Autocorrelation::single_exponential, 3, 1);
  const auto message = [&](const FieldModel& tried, const std::vector<Measurement>& measurements) -> std::string {
    try {
      alone(tried, 0, 1, measurements);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(plain, {{3, 25e3, 0, "b.tsv:2"}, {3, 26e3, 0, "b.tsv:3"}}),
            "[field.cohesion]: b.tsv:3: found 2.6e+04, but b.tsv:2 gives the same cell 2.5e+04; give them an error, or take a finer mesh");
  EXPECT_EQ(message(plain, {{3, -1, 0, "b.tsv:2"}}),
            "[field.cohesion]: b.tsv:2: found -1, a value that the marginal distribution does not have");
  EXPECT_EQ(message(plain, {{3, 100e3, 0, "b.tsv:2"}}),
            "[field.cohesion]: b.tsv:2: found 1e+05, a value that the marginal distribution has less than once in 10^9 cells; check its "
            "unit, mean and cov");
  FieldModel empirical = plain;
  empirical.marginal = {};
  empirical.marginal.distribution = Distribution::empirical;
  empirical.marginal.data = {14e3, 20e3, 20e3, 28e3};
  EXPECT_EQ(message(empirical, {{3, 14e3, 1e3, "b.tsv:2"}}),
            "[field.cohesion]: b.tsv:2: found an error of 1000 at a value where the empirical distribution is level, so that it has no "
            "meaning; leave it out");
  EXPECT_EQ(message(empirical, {{3, 14e3, 0, "b.tsv:2"}, {9, 20e3, 0, "b.tsv:3"}}), "");
  const FieldModel smooth = model({0.001, 0.001, 9, 4}, Autocorrelation::squared_exponential, 3, 1);
  EXPECT_EQ(message(smooth, {{3, 25e3, 0, "a"}, {4, 25e3, 0, "b"}, {5, 26e3, 0, "c"}, {6, 26e3, 0, "d"}}),
            "[field.cohesion]: the measurements lie too close together for this correlation; give them an error");
}

}  // namespace
}  // namespace slidezone
