// Random fields: autocorrelation, averages over cells, meshes.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "core/vec2.hpp"
#include "field/autocorrelation.hpp"
#include "field/gaussian_field.hpp"
#include "field/local_average.hpp"
#include "field/mesh.hpp"
#include "field/mesh_covariance.hpp"
#include "field/model.hpp"
#include "field_models.hpp"

namespace slidezone {
namespace {

// ---- autocorrelation ----

/// Twice the integral of rho from 0 to where it has vanished, by Simpson's rule between the kinks.
double integral(Autocorrelation function, double nu) {
  const auto simpson = [&](double from, double to, int n) {
    const double h = (to - from) / n;
    double sum = autocorrelation(function, nu, from) + autocorrelation(function, nu, to);
    for (int i = 1; i < n; ++i) sum += (i % 2 == 0 ? 2 : 4) * autocorrelation(function, nu, from + i * h);
    return sum * h / 3;
  };
  return 2 * (simpson(0, 1e-6, 200) + simpson(1e-6, 1e-3, 2000) + simpson(1e-3, 1, 20000) + simpson(1, 4. / 3, 2000) +
              simpson(4. / 3, 60, 200000));
}

TEST(Autocorrelation, IsOneAtNoLagAndIntegratesToItsScale) {
  for (const Autocorrelation function : every_function)
    for (const double nu : {0.3, 1.1, 4.0}) {
      EXPECT_NEAR(autocorrelation(function, nu, 0), 1, 1e-15) << name_of(function);
      EXPECT_NEAR(integral(function, nu), 1, 1e-8) << name_of(function) << " " << nu;  // Simpson's error at Matern's cusp
    }
}

TEST(Autocorrelation, HasThePublishedValuesAtHalfAScale) {  // all digits given
  EXPECT_NEAR(autocorrelation(Autocorrelation::single_exponential, 0, 0.5), 0.367879441171, 1e-12);
  EXPECT_NEAR(autocorrelation(Autocorrelation::squared_exponential, 0, 0.5), 0.455938127766, 1e-12);
  EXPECT_NEAR(autocorrelation(Autocorrelation::second_order_markov, 0, 0.5), 0.406005849710, 1e-12);
}

TEST(Autocorrelation, MaternHoldsTheMarkovFunctions) {
  for (double t = 1e-6; t < 30; t *= 1.5) {
    const auto matern = [&](double nu) { return autocorrelation(Autocorrelation::matern, nu, t); };
    EXPECT_NEAR(matern(0.5), autocorrelation(Autocorrelation::single_exponential, 0, t), 1e-13) << t;
    EXPECT_NEAR(matern(1.5), autocorrelation(Autocorrelation::second_order_markov, 0, t), 1e-13) << t;
    EXPECT_NEAR(matern(2.5), autocorrelation(Autocorrelation::third_order_markov, 0, t), 1e-13) << t;
    EXPECT_NEAR(matern(50), autocorrelation(Autocorrelation::squared_exponential, 0, t), 0.01) << t;  // its limit
  }
}

TEST(Autocorrelation, PlaneLagsFollowShapeAndBedding) {
  Correlation correlation = model({}, Autocorrelation::single_exponential, 4, 8).correlation;
  EXPECT_DOUBLE_EQ(autocorrelation(correlation, -1, 2), std::exp(-1.0));  // Eq. 24
  correlation.shape = LagShape::elliptical;
  EXPECT_DOUBLE_EQ(autocorrelation(correlation, 3, -8), std::exp(-2 * 1.25));
  correlation.bedding_angle = std::numbers::pi / 6;  // 30 degrees: one scale along the bedding, one across it
  EXPECT_NEAR(autocorrelation(correlation, 4 * std::sqrt(0.75), 4 * 0.5), std::exp(-2.0), 1e-15);
  EXPECT_NEAR(autocorrelation(correlation, 8 * -0.5, 8 * std::sqrt(0.75)), std::exp(-2.0), 1e-15);
  EXPECT_FALSE(is_separable(correlation));
}

TEST(Autocorrelation, IsPositiveDefiniteButForRoundBinaryNoise) {
  for (const Autocorrelation function : every_function) {
    const FieldModel product = model({0.25, 0.25, 16, 14}, function, 1.3, 0.9);
    for (const FieldModel& tried : {product, elliptical(product), elliptical(product, 0.4)}) {
      const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full_covariance(tried)).eigenvalues()(0);
      const bool is_round_noise = function == Autocorrelation::binary_noise && tried.correlation.shape == LagShape::elliptical;
      if (is_round_noise)
        EXPECT_LT(least, -0.01);
      else
        EXPECT_GT(least, -1e-13) << name_of(function);
    }
  }
}

// ---- local averages ----

TEST(LocalAverage, VarianceIsTheVarianceFunction) {  // all digits given
  const double lengths[] = {0.1, 0.5, 1, 2};
  const struct {
    Autocorrelation function;
    double values[4];
  } published[] = {
      {Autocorrelation::single_exponential, {.936537653899, .735758882343, .567667641618, .377289454861}},
      {Autocorrelation::squared_exponential, {.994796727262, .887096098601, .683256649036, .420422538386}},
      {Autocorrelation::second_order_markov, {.988601956515, .838338208092, .641026184028, .406365315278}},
  };
  for (const auto& [function, values] : published)
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(average_covariance(function, 0, lengths[i], 0), values[i], 1e-12) << name_of(function);
}

TEST(LocalAverage, AveragesOfAveragesAreAverages) {
  // The mean of n adjoining averages is the average over n lengths: n^2 gamma(n T) = sum of their covariances.
  for (const Autocorrelation function : every_function) {
    double sum = 0;
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b) sum += average_covariance(function, smoothness, 0.3, a - b);
    EXPECT_NEAR(sum / 36, average_covariance(function, smoothness, 1.8, 0), 1e-10) << name_of(function);
  }
}

TEST(LocalAverage, CellsMayBeAnyNumberOfScalesLong) {
  for (const double length : {1e-3, 30., 1e3, 1e5, 1e7}) {
    const auto covariance = [&](double k) { return average_covariance(Autocorrelation::single_exponential, 0, length, k); };
    const double decay = -std::expm1(-2 * length);
    // In closed form; the first loses digits to cancellation where cells are short.
    EXPECT_NEAR(covariance(0) / ((2 * length - decay) / (2 * length * length)), 1, length < 1 ? 1e-9 : 1e-7) << length;
    EXPECT_NEAR(covariance(1) / (decay * decay / (4 * length * length)), 1, 1e-7) << length;  // 1e-13 of 2e-15 at the last
  }
}

TEST(LocalAverage, FieldsHaveIt) {
  FieldModel averaged = model({1, 0.5, 7, 6}, Autocorrelation::single_exponential, 3, 1);
  averaged.average = Average::cell;
  Eigen::MatrixXd covariance(42, 42);
  for (int a = 0; a < 42; ++a)
    for (int b = 0; b < 42; ++b)
      covariance(a, b) = average_covariance(Autocorrelation::single_exponential, 0, 1. / 3, a % 7 - b % 7) *
                         average_covariance(Autocorrelation::single_exponential, 0, 0.5, a / 7 - b / 7);
  EXPECT_LT((full_covariance(averaged) - covariance).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(GaussianField(averaged).report().method, "separable");
  for (const Method method : {Method::separable, Method::circulant})
    expect_covariance(with_method(averaged, method), covariance, "average");
  FieldModel whole = with_method(averaged, Method::karhunen_loeve);
  whole.variance_kept = 1;
  expect_covariance(whole, covariance, "average by all modes");
  EXPECT_NEAR(GaussianField(whole).report().covariance_error, 0, 1e-12);
  EXPECT_THROW(GaussianField(elliptical(averaged)), Error);
}

// ---- mesh ----

TEST(FieldMesh, FindsTheCellOfEachPoint) {
  const FieldMesh mesh{0.5, 0.25, 4, 3};
  const std::vector<double> x = {0, 0.2, 0.5, 1.99, 2, 1.1};
  const std::vector<double> y = {0, 0.25, 0.1, 0.74, 0.75, 0.6};
  EXPECT_EQ(containing_cells(mesh, x, y), (std::vector<std::size_t>{0, 4, 1, 11, 11, 10}));
}

TEST(FieldMesh, InterpolatesLinearFieldsExactly) {
  const FieldMesh mesh{0.5, 0.25, 4, 3};
  const auto plane = [](Vec2 at) { return 3 + 2 * at.x - 5 * at.y; };
  std::vector<double> field;
  for (std::size_t cell = 0; cell < mesh.size(); ++cell)
    field.push_back(plane({(static_cast<double>(cell % 4) + 0.5) * 0.5, (static_cast<double>(cell / 4) + 0.5) * 0.25}));
  const std::vector<double> x = {0.25, 0.3, 1.0, 1.75, 0.1, 2.0};
  const std::vector<double> y = {0.125, 0.5, 0.2, 0.625, 0.3, 0.75};
  const Vec2 at[] = {{0.25, 0.125}, {0.3, 0.5}, {1.0, 0.2}, {1.75, 0.625}, {0.25, 0.3}, {1.75, 0.625}};  // held at the outermost centres
  const std::vector<Neighbours> all = neighbours(mesh, x, y);
  for (std::size_t p = 0; p < x.size(); ++p) {
    double value = 0;
    for (std::size_t k = 0; k < 4; ++k) value += all[p].weights[k] * field.at(all[p].cells[k]);
    EXPECT_NEAR(value, plane(at[p]), 1e-14) << p;
  }
  EXPECT_THROW(neighbours(mesh, std::vector{2.1}, std::vector{0.1}), Error);
}

TEST(FieldMesh, NamesAPointOutside) {
  const FieldMesh mesh{0.5, 0.25, 4, 3};
  for (const Vec2 wrong : {Vec2{2.25, 0.5}, Vec2{-1e-9, 0}, Vec2{1, 0.76}, Vec2{std::numeric_limits<double>::quiet_NaN(), 0}})
    EXPECT_THROW(containing_cells(mesh, std::vector{1.0, wrong.x}, std::vector{0.5, wrong.y}), Error);
  try {
    containing_cells(mesh, std::vector{1.0, 2.25}, std::vector{0.5, 0.5});
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "point 2 at (2.25 m, 0.5 m) lies outside the mesh of the random field, which is 2 m x 0.75 m from the origin");
    EXPECT_EQ(error.code(), ExitCode::data);
  }
}

}  // namespace
}  // namespace slidezone
