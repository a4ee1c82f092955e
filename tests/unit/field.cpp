// Random fields. Seeds are fixed; limits of ensemble tests lie four standard errors out, which a right sampler misses once
// in 16,000 seeds.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/vec2.hpp"
#include "field/exponential.hpp"
#include "field/lognormal.hpp"
#include "field/mesh.hpp"
#include "field/random_field.hpp"

namespace slidezone {
namespace {

Vec2 center(const FieldMesh& mesh, std::size_t cell) {
  const auto columns = static_cast<std::size_t>(mesh.cells_x);
  return {(static_cast<double>(cell % columns) + 0.5) * mesh.cell_x, (static_cast<double>(cell / columns) + 0.5) * mesh.cell_y};
}

/// The autocorrelation matrix of all cells of a mesh.
Eigen::MatrixXd correlation_matrix(const FieldMesh& mesh, double scale_x, double scale_y) {
  const auto n = static_cast<Eigen::Index>(mesh.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const Vec2 a = center(mesh, static_cast<std::size_t>(i)), b = center(mesh, static_cast<std::size_t>(j));
      matrix(i, j) = single_exponential(a.x - b.x, a.y - b.y, scale_x, scale_y);
    }
  return matrix;
}

/// The Gaussian field that the separable factor makes of these normals.
std::vector<double> separable(std::vector<double> normals, const FieldMesh& mesh, double scale_x, double scale_y) {
  const auto row_size = static_cast<std::size_t>(mesh.cells_x);
  correlate_along_rows(normals, row_size, exponential_factor(mesh.cell_x, scale_x));
  correlate_across_rows(normals, row_size, exponential_factor(mesh.cell_y, scale_y));
  return normals;
}

// ---- autocorrelation and factor ----

TEST(SingleExponential, HasTheValuesOfItsEquation) {
  EXPECT_NEAR(single_exponential(0.5, 0, 1, 7), 0.367879441171, 1e-12);  // at half a scale, 12 digits given
  EXPECT_DOUBLE_EQ(single_exponential(-1, 2, 4, 8), std::exp(-1.0));
  EXPECT_EQ(single_exponential(0, 0, 1, 1), 1);
}

TEST(ExponentialFactor, HasTheClosedForm) {
  const double spacing = 0.1, scale = 48;
  const std::size_t n = 40;
  const double a = std::exp(-2 * spacing / scale);
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<double> column(n, 0);
    column[j] = 1;
    correlate_along_rows(column, n, exponential_factor(spacing, scale));
    for (std::size_t i = 0; i < n; ++i) {
      const double expected = i < j ? 0 : std::pow(a, double(i - j)) * (j == 0 ? 1 : std::sqrt(1 - a * a));
      EXPECT_NEAR(column[i], expected, 1e-14) << i << " " << j;  // sqrt(1 - a^2) is the less exact of the two
    }
  }
}

TEST(ExponentialFactor, EqualsDenseCholeskyForTheSameNormals) {
  const FieldMesh mesh{0.1, 0.2, 23, 19};
  for (const double scale : {0.3, 1.0, 10.0}) {
    std::vector<double> normals(mesh.size());
    fill_normals(normals, {1, purpose("cohesion"), 1});
    const Eigen::MatrixXd factor = correlation_matrix(mesh, scale, 0.6 * scale).llt().matrixL();
    const Eigen::VectorXd dense = factor * Eigen::Map<const Eigen::VectorXd>(normals.data(), Eigen::Index(normals.size()));
    const std::vector<double> field = separable(normals, mesh, scale, 0.6 * scale);
    for (std::size_t i = 0; i < field.size(); ++i) EXPECT_NEAR(field[i], dense(Eigen::Index(i)), 1e-12) << i;
  }
}

TEST(ExponentialFactor, TreatsAnyNumberOfRowsAlike) {
  for (const int rows : {1, 7, 8, 9, 20}) {
    const FieldMesh mesh{0.1, 0.1, 11, rows};
    std::vector<double> normals(mesh.size());
    fill_normals(normals, {3, 0, 1});
    std::vector<double> expected = normals;
    const ExponentialFactor factor = exponential_factor(0.1, 1);
    for (std::size_t i = 0; i < expected.size(); ++i)
      if (i % 11 > 0) expected[i] = factor.memory * expected[i - 1] + factor.innovation * normals[i];
    correlate_along_rows(normals, 11, factor);
    EXPECT_EQ(normals, expected) << rows;
  }
}

TEST(ExponentialFactor, GivesTheEnsembleItsCorrelation) {
  // Products of two cells over n independent samples: standard error sqrt((1 + rho^2) / n).
  const FieldMesh mesh{0.5, 0.25, 12, 9};
  const std::size_t n = 40000;
  struct Pair {
    std::size_t a, b;
    double sum = 0;
  };
  std::vector<Pair> pairs = {{0, 0}, {0, 1}, {0, 11}, {0, 12}, {5, 53}, {40, 67}, {107, 0}, {107, 107}, {95, 107}, {30, 33}};
  std::vector<double> values(mesh.size());
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    fill_normals(values, {11, 0, sample});
    values = separable(std::move(values), mesh, 3, 1);
    for (Pair& pair : pairs) pair.sum += values[pair.a] * values[pair.b];
  }
  for (const Pair& pair : pairs) {
    const Vec2 a = center(mesh, pair.a), b = center(mesh, pair.b);
    const double rho = single_exponential(a.x - b.x, a.y - b.y, 3, 1);
    EXPECT_NEAR(pair.sum / double(n), rho, 4 * std::sqrt((1 + rho * rho) / double(n))) << pair.a << " " << pair.b;
  }
}

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

// ---- samples ----

const FieldModel benchmark{{0.1, 0.1, 250, 50}, 1, 1, 20e3, 0.5, 4e3};

TEST(RandomField, HasMeanCovAndFloorsOfItsModel) {
  // 400 samples of 25 m x 5 m: the mean over one has variance sd^2 times the product of the variance functions of its
  // sides; the lognormal's correlation is below the Gaussian's, which serves as a bound.
  const auto variance_function = [](double scales) { return (2 * scales + std::expm1(-2 * scales)) / (2 * scales * scales); };
  const double n = 400, reduction = variance_function(25) * variance_function(5);
  double sum = 0, squares = 0, floored = 0;
  std::vector<double> values(benchmark.mesh.size());
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    floored += double(fill_sample(values, benchmark, {1, purpose("cohesion"), sample}));
    for (const double value : values) sum += value, squares += value * value;
  }
  const double cells = n * double(benchmark.mesh.size());
  const double mean = sum / cells, cov = std::sqrt(squares / cells - mean * mean) / mean;
  EXPECT_NEAR(mean / 20e3, 1, 4 * 0.5 * std::sqrt(reduction / n));
  // Standard deviations over 40 seeds: 0.2 % of the COV, 3.4 % of the floored count (floored cells come in clusters).
  EXPECT_NEAR(cov / 0.5, 1, 4 * 0.002);
  EXPECT_NEAR(floored / cells / 7.6e-4, 1, 4 * 0.034);
}

TEST(RandomField, SamplesDoNotDependOnEachOther) {
  std::vector<double> alone(benchmark.mesh.size()), among(benchmark.mesh.size());
  for (std::uint32_t sample = 1; sample <= 3; ++sample) fill_sample(among, benchmark, {7, 1, sample});
  fill_sample(alone, benchmark, {7, 1, 3});
  EXPECT_EQ(alone, among);
  fill_sample(among, benchmark, {7, 1, 4});
  EXPECT_NE(alone, among);
}

// ---- mesh ----

TEST(FieldMesh, FindsTheCellOfEachPoint) {
  const FieldMesh mesh{0.5, 0.25, 4, 3};
  const std::vector<double> x = {0, 0.2, 0.5, 1.99, 2, 1.1};
  const std::vector<double> y = {0, 0.25, 0.1, 0.74, 0.75, 0.6};
  EXPECT_EQ(containing_cells(mesh, x, y), (std::vector<std::size_t>{0, 4, 1, 11, 11, 10}));
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
