// Random fields. Seeds are fixed; limits of ensemble tests lie four standard errors out, which a right sampler misses once
// in 16,000 seeds.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/vec2.hpp"
#include "field/autocorrelation.hpp"
#include "field/cell_transform.hpp"
#include "field/circulant.hpp"
#include "field/conditioning.hpp"
#include "field/covariance_factor.hpp"
#include "field/cross_correlation.hpp"
#include "field/exponential.hpp"
#include "field/gaussian_field.hpp"
#include "field/karhunen_loeve.hpp"
#include "field/latin_hypercube.hpp"
#include "field/local_average.hpp"
#include "field/lognormal.hpp"
#include "field/marginal.hpp"
#include "field/mesh.hpp"
#include "field/mesh_covariance.hpp"
#include "field/model.hpp"
#include "field/nataf.hpp"
#include "field/random_fields.hpp"

namespace slidezone {
namespace {

constexpr Autocorrelation every_function[] = {
    Autocorrelation::single_exponential,
    Autocorrelation::squared_exponential,
    Autocorrelation::second_order_markov,
    Autocorrelation::third_order_markov,
    Autocorrelation::cosine_exponential,
    Autocorrelation::binary_noise,
    Autocorrelation::matern,
    Autocorrelation::spherical,
};

std::string name_of(Autocorrelation function) { return autocorrelation_names()[static_cast<std::size_t>(function)]; }

constexpr double smoothness = 1.1;  // of Matern, where it does not matter

FieldModel model(FieldMesh mesh, Autocorrelation function, double scale_x, double scale_y) {
  FieldModel model;
  model.mesh = mesh;
  model.correlation.function = function;
  model.correlation.smoothness = smoothness;
  model.correlation.horizontal_scale = scale_x;
  model.correlation.vertical_scale = scale_y;
  model.marginal.mean = 20e3;
  model.marginal.cov = 0.25;
  return model;
}

FieldModel with_method(FieldModel model, Method method) {
  model.method = method;
  return model;
}

FieldModel elliptical(FieldModel model, double bedding_angle = 0) {
  model.correlation.shape = LagShape::elliptical;
  model.correlation.bedding_angle = bedding_angle;
  return model;
}

const FieldMesh strip{0.5, 0.25, 9, 4};

/// One field alone.
RandomFields alone(const FieldModel& model, double floor, std::uint64_t seed, std::vector<Measurement> measurements = {}) {
  return RandomFields({{"cohesion", model, {.low = floor}, false, std::move(measurements)}}, {}, seed);
}

std::vector<double> gaussian_sample(const FieldModel& model, RandomStream stream) {
  GaussianField field(model);
  std::vector<double> values(model.mesh.size());
  field.fill(values, stream);
  return values;
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Compares products of pairs of cells over n samples with the covariance; their standard error is sqrt((1 + rho^2) / n).
void expect_covariance(const FieldModel& model, const Eigen::MatrixXd& covariance, const std::string& what) {
  GaussianField field(model);
  constexpr std::size_t n = 5000;
  const std::size_t cells = model.mesh.size(), stride = std::max<std::size_t>(1, cells / 12);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(Eigen::Index(cells), Eigen::Index(cells));
  std::vector<double> values(cells);
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    field.fill(values, {11, 0, sample});
    for (std::size_t a = 0; a < cells; a += stride)
      for (std::size_t b = a; b < cells; ++b) sums(Eigen::Index(a), Eigen::Index(b)) += values[a] * values[b];
  }
  for (std::size_t a = 0; a < cells; a += stride)
    for (std::size_t b = a; b < cells; ++b) {
      const double rho = covariance(Eigen::Index(a), Eigen::Index(b));
      // Some 900 pairs, so 4.5 standard errors: a right sampler misses one in 150 of these tests.
      EXPECT_NEAR(sums(Eigen::Index(a), Eigen::Index(b)) / double(n), rho, 4.5 * std::sqrt((1 + rho * rho) / double(n)))
          << what << ": " << a << " " << b;
    }
}

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

// ---- methods ----

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

TEST(GaussianField, FactorsAreCholeskysForTheSameNormals) {
  // Scales of up to 10 cells; beyond them Cholesky's own rounding grows.
  for (const Autocorrelation function : every_function)
    for (const double scale : {0.3, 1.0}) {
      const FieldModel benign = model({0.1, 0.2, 23, 19}, function, scale, 0.6 * scale);
      if (function == Autocorrelation::squared_exponential && scale > 0.3) continue;  // indefinite to rounding
      const std::vector<double> dense = gaussian_sample(with_method(benign, Method::cholesky), {1, 7, 1});
      EXPECT_LT(largest_difference(gaussian_sample(with_method(benign, Method::separable), {1, 7, 1}), dense), 1e-12) << name_of(function);
    }
  const FieldModel exponential = model({0.1, 0.2, 23, 19}, Autocorrelation::single_exponential, 10, 6);
  EXPECT_LT(
      largest_difference(gaussian_sample(exponential, {1, 7, 1}), gaussian_sample(with_method(exponential, Method::cholesky), {1, 7, 1})),
      1e-12);
}

TEST(GaussianField, CholeskyMultipliesByEigensFactor) {
  const FieldModel round = with_method(elliptical(model({0.1, 0.2, 12, 9}, Autocorrelation::spherical, 1, 0.6), 0.3), Method::cholesky);
  std::vector<double> normals(round.mesh.size());
  fill_normals(normals, {1, 7, 1});
  const Eigen::MatrixXd factor = full_covariance(round).llt().matrixL();
  const Eigen::VectorXd expected = factor * Eigen::Map<const Eigen::VectorXd>(normals.data(), Eigen::Index(normals.size()));
  EXPECT_LT(largest_difference(gaussian_sample(round, {1, 7, 1}), {expected.data(), normals.size()}), 1e-14);
}

TEST(GaussianField, EveryMethodGivesTheEnsembleItsCovariance) {
  for (const Autocorrelation function : every_function) {
    const FieldModel product = model({0.5, 0.25, 9, 8}, function, 3, 1);
    for (const Method method : {Method::separable, Method::circulant, Method::cholesky})
      expect_covariance(with_method(product, method), full_covariance(product),
                        name_of(function) + " by " + method_names()[static_cast<std::size_t>(method)]);
    if (function == Autocorrelation::binary_noise) continue;
    const FieldModel bedded = elliptical(product, 0.3);
    expect_covariance(bedded, full_covariance(bedded), name_of(function) + " elliptical and bedded");
  }
}

TEST(GaussianField, NuggetIsNoiseFromCellToCell) {
  FieldModel noisy = model({0.5, 0.25, 9, 8}, Autocorrelation::single_exponential, 3, 1);
  const Eigen::MatrixXd covariance = 0.7 * full_covariance(noisy) + 0.3 * Eigen::MatrixXd::Identity(72, 72);
  noisy.correlation.nugget = 0.3;
  expect_covariance(noisy, covariance, "nugget");
}

TEST(GaussianField, KarhunenLoeveKeepsTheWantedShare) {
  for (const bool is_bedded : {false, true}) {
    FieldModel cut = with_method(model({0.5, 0.25, 9, 8}, Autocorrelation::squared_exponential, 3, 1), Method::karhunen_loeve);
    if (is_bedded) cut = elliptical(cut, 0.3);
    cut.variance_kept = 0.8;
    const KarhunenLoeve expansion = karhunen_loeve(cut);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(full_covariance(cut));
    const auto kept = Eigen::Index(expansion.modes.size());
    const Eigen::VectorXd lambda = solver.eigenvalues().tail(kept);
    EXPECT_NEAR(expansion.variance_kept, lambda.sum() / 72, 1e-12);
    EXPECT_GE(expansion.variance_kept, 0.8);
    EXPECT_LT((lambda.sum() - lambda(0)) / 72, 0.8);  // no fewer would do
    const Eigen::MatrixXd modes = solver.eigenvectors().rightCols(kept);
    const Eigen::MatrixXd covariance = modes * lambda.asDiagonal() * modes.transpose();
    EXPECT_NEAR(expansion.covariance_error, 1 - covariance.diagonal().minCoeff(), 1e-12);
    expect_covariance(cut, covariance, "Karhunen-Loeve");
  }
}

TEST(GaussianField, ChoosesTheCheapestExactMethod) {
  const auto chosen = [](const FieldModel& tried) { return GaussianField(tried).report().method; };
  const FieldModel exponential = model({0.1, 0.1, 30, 20}, Autocorrelation::single_exponential, 1, 1);
  FieldModel markov = model({0.1, 0.1, 30, 20}, Autocorrelation::second_order_markov, 1, 1);
  EXPECT_EQ(chosen(exponential), "sweep");
  EXPECT_EQ(chosen(markov), "separable");
  EXPECT_EQ(chosen(elliptical(markov)), "circulant");
  markov.correlation.bedding_angle = 0.1;
  EXPECT_EQ(chosen(markov), "circulant");
  markov = model({0.1, 0.1, 2000, 2}, Autocorrelation::second_order_markov, 1, 1);
  EXPECT_EQ(chosen(markov), "circulant");
}

TEST(GaussianField, IsTheSameWhateverWasDrawnBefore) {
  for (const Method method : {Method::separable, Method::circulant, Method::cholesky, Method::karhunen_loeve}) {
    GaussianField field(with_method(model({0.5, 0.25, 9, 8}, Autocorrelation::spherical, 3, 1), method));
    std::vector<double> first(72), again(72);
    field.fill(first, {1, 2, 3});
    field.fill(again, {1, 2, 4});
    EXPECT_NE(first, again);
    field.fill(again, {1, 2, 3});
    EXPECT_EQ(first, again);
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

// ---- guards of positive definiteness ----

TEST(Guards, ClippedFactorsStayExactToRounding) {
  // Squared exponential with 30 cells to a scale: Cholesky's method fails, the clipped root is off by no more than rounding.
  const FieldModel smooth = model({0.1, 0.1, 100, 1}, Autocorrelation::squared_exponential, 3, 3);
  const Eigen::MatrixXd covariance = row_covariance(smooth);
  ASSERT_NE(covariance.llt().info(), Eigen::Success);
  const CovarianceFactor factor = clipped_factor(covariance);
  EXPECT_GT(factor.error, 0);
  EXPECT_LT(factor.error, 1e-13);
  double error = 0;
  for (std::size_t i = 0; i < 100; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k <= j; ++k) sum += factor.lower.entry(i, k) * factor.lower.entry(j, k);
      error = std::max(error, std::abs(sum - covariance(Eigen::Index(i), Eigen::Index(j))));
    }
  EXPECT_NEAR(error, factor.error, 1e-15);
}

TEST(Guards, ClippedFactorIsCholeskysWhereThatExists) {
  const Eigen::MatrixXd covariance = row_covariance(model({0.1, 0.1, 40, 1}, Autocorrelation::second_order_markov, 0.5, 1));
  const Eigen::MatrixXd cholesky = covariance.llt().matrixL();
  // A hair of negative eigenvalue, from one more row that repeats the last, sends it down the other road.
  Eigen::MatrixXd singular(41, 41);
  singular.topLeftCorner(40, 40) = covariance;
  singular.bottomRows(1).leftCols(40) = covariance.bottomRows(1);
  singular.rightCols(1).topRows(40) = covariance.rightCols(1);
  singular(40, 40) = 1 - 1e-14;
  ASSERT_NE(singular.llt().info(), Eigen::Success);
  const CovarianceFactor factor = clipped_factor(singular);
  for (std::size_t i = 0; i < 40; ++i)
    for (std::size_t k = 0; k <= i; ++k) EXPECT_NEAR(factor.lower.entry(i, k), cholesky(Eigen::Index(i), Eigen::Index(k)), 1e-12);
}

TEST(Guards, JitterIsBoundedAndReported) {
  const Eigen::MatrixXd smooth = row_covariance(model({0.1, 0.1, 100, 1}, Autocorrelation::squared_exponential, 3, 3));
  const double jitter = jittered_factor(smooth).error;
  EXPECT_GT(jitter, 0);
  EXPECT_LE(jitter, 1e-8);
  Eigen::MatrixXd indefinite = Eigen::MatrixXd::Identity(3, 3);
  indefinite(0, 1) = indefinite(1, 0) = 1.1;
  EXPECT_THROW(jittered_factor(indefinite), Error);
}

TEST(Guards, PaddingGrowsUntilTheSpectrumIsNotNegative) {
  const FieldModel wide = elliptical(model({0.1, 0.1, 30, 20}, Autocorrelation::squared_exponential, 6, 1));
  const CirculantEmbedding embedding(wide);
  EXPECT_GT(embedding.cells_x(), 240u);  // 6 m are 60 cells; correlation vanishes at some 3 scales either way
  EXPECT_LE(embedding.cells_y(), 80u);   // this axis needs no more
  EXPECT_LT(embedding.covariance_error(), 1e-10);
  expect_covariance(with_method(elliptical(model({0.5, 0.5, 9, 8}, Autocorrelation::squared_exponential, 30, 5)), Method::circulant),
                    full_covariance(elliptical(model({0.5, 0.5, 9, 8}, Autocorrelation::squared_exponential, 30, 5))), "wide");
}

TEST(Guards, RefusalsSayWhy) {
  const auto message = [](const std::function<void()>& act) -> std::string {
    try {
      act();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::data);
      return error.what();
    }
    return "";
  };
  const FieldModel wide = model({0.1, 0.1, 30, 20}, Autocorrelation::squared_exponential, 600, 1);
  EXPECT_TRUE(
      message([&] { CirculantEmbedding(wide, 100000); }).starts_with("circulant embedding needs eigenvalues that are not negative"));
  EXPECT_TRUE(message([&] { CirculantEmbedding(wide, 1000); }).starts_with("circulant embedding would pad the mesh to 60 x 40 cells"));
  const FieldModel large = model({0.1, 0.1, 1000, 1000}, Autocorrelation::spherical, 1, 1);
  EXPECT_TRUE(message([&] {
                GaussianField(with_method(large, Method::cholesky));
              }).starts_with("method \"Cholesky\" would take 16000 GB of memory for 1000000 cells"));
  EXPECT_TRUE(message([&] { GaussianField(with_method(elliptical(large), Method::separable)); }).starts_with("method \"separable\" wants"));
  EXPECT_TRUE(message([&] {
                GaussianField(elliptical(model({0.1, 0.1, 5, 5}, Autocorrelation::binary_noise, 1, 1)));
              }).find("not positive definite") != std::string::npos);
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

// ---- other marginals ----

Marginal marginal(Distribution distribution, double cov) { return {distribution, 20e3, cov, 5e3, 60e3, {}}; }

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

// ---- designs ----

RandomFields designed(const FieldModel& model, StudyDesign design) {
  return RandomFields({{"cohesion", model, {}, false, {}}}, {}, 3, design);
}

FieldModel normal_strip() {
  FieldModel normal = model(strip, Autocorrelation::single_exponential, 3, 1);
  normal.marginal.distribution = Distribution::normal;
  return normal;
}

/// Standard normals of one sample of a field of normal marginal.
Eigen::VectorXd gaussian_of(RandomFields& fields, std::uint32_t sample, std::size_t cells) {
  std::vector<double> values(cells);
  fields.fill(0, values, sample);
  return (Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(cells)).array() / 20e3 - 1) / 0.25;
}

TEST(Design, AntitheticPairsAreMirrorImages) {
  FieldModel noisy = normal_strip();
  noisy.correlation.nugget = 0.2;
  RandomFields pairs = designed(noisy, {.design = Design::antithetic}), plain = designed(noisy, {});
  EXPECT_LT((gaussian_of(pairs, 5, 36) + gaussian_of(pairs, 6, 36)).cwiseAbs().maxCoeff(), 1e-12);  // rounding of 1e4 Pa
  EXPECT_EQ(gaussian_of(pairs, 5, 36), gaussian_of(plain, 5, 36));
  EXPECT_NE(gaussian_of(pairs, 7, 36), gaussian_of(pairs, 5, 36));
}

TEST(Design, AntitheticPairsMeetMeasurements) {
  // About the kriging mean a pair is mirrored, errors of measurement included: their mean is that of every pair.
  const std::vector<Measurement> measured = {{3, 25e3, 0, "a"}, {30, 14e3, 2e3, "b"}};
  RandomFields pairs({{"cohesion", normal_strip(), {}, false, measured}}, {}, 3, {.design = Design::antithetic});
  const Eigen::VectorXd first = gaussian_of(pairs, 1, 36), mean = (first + gaussian_of(pairs, 2, 36)) / 2;
  EXPECT_NEAR(first(3), 1, 1e-10);
  EXPECT_GT((first - mean).cwiseAbs().maxCoeff(), 0.5);
  EXPECT_LT((mean - (gaussian_of(pairs, 3, 36) + gaussian_of(pairs, 4, 36)) / 2).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Design, HypercubeFillsEveryStratumOfEveryModeOnce) {
  for (const bool is_bedded : {false, true}) {
    FieldModel noisy = normal_strip();
    noisy.correlation.nugget = 0.1;
    if (is_bedded) noisy.correlation.bedding_angle = 0.3;
    const StudyDesign design{.design = Design::latin_hypercube, .block_size = 8, .modes = 6};
    RandomFields fields = designed(noisy, design);
    const Eigen::MatrixXd covariance = 0.9 * full_covariance(noisy) + 0.1 * Eigen::MatrixXd::Identity(36, 36);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    EXPECT_NEAR(fields.hypercube(0)->variance_share(), solver.eigenvalues().tail(6).sum() / 36, 1e-12);
    for (Eigen::Index mode = 30; mode < 36; ++mode) {
      std::vector<int> count(8, 0);
      for (std::uint32_t sample = 9; sample <= 16; ++sample) {
        const double amplitude =
            solver.eigenvectors().col(mode).dot(gaussian_of(fields, sample, 36)) / std::sqrt(solver.eigenvalues()(mode));
        ++count[std::size_t(8 * std::erfc(-amplitude / std::numbers::sqrt2) / 2)];
      }
      EXPECT_EQ(count, std::vector<int>(8, 1)) << mode;
    }
  }
}

TEST(Design, HypercubeLeavesTheCovarianceAlone) {
  RandomFields fields = designed(normal_strip(), {.design = Design::latin_hypercube, .block_size = 5, .modes = 10});
  const Eigen::MatrixXd covariance = full_covariance(normal_strip());
  const double n = 5000;
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(36, 36);
  for (std::uint32_t sample = 1; sample <= n; ++sample) {
    const Eigen::VectorXd g = gaussian_of(fields, sample, 36);
    sums += g * g.transpose() / n;
  }
  for (Eigen::Index i = 0; i < 36; i += 5)
    for (Eigen::Index j = i; j < 36; ++j)  // some 160 pairs: 4.5 standard errors, of independent samples; those of blocks are smaller
      EXPECT_NEAR(sums(i, j), covariance(i, j), 4.5 * std::sqrt((1 + covariance(i, j) * covariance(i, j)) / n)) << i << " " << j;
}

TEST(Design, HypercubeMakesMeansScatterLess) {
  // The mean over all cells and over one block of 10: what ten modes decide of it scatters with 1/n^3 in place of 1/n.
  const auto scatter = [](const StudyDesign& design) {
    RandomFields fields = designed(normal_strip(), design);
    double squares = 0;
    for (std::uint32_t block = 0; block < 200; ++block) {
      double mean = 0;
      for (std::uint32_t i = 1; i <= 10; ++i) mean += gaussian_of(fields, 10 * block + i, 36).mean() / 10;
      squares += mean * mean / 200;
    }
    return squares;
  };
  // Either is known to 10 % (200 blocks); these modes hold 98 % of the variance of the mean over all cells.
  EXPECT_LT(scatter({.design = Design::latin_hypercube, .block_size = 10, .modes = 10}) / scatter({}), 0.1);
}

TEST(Design, SamplesOfAHypercubeDoNotDependOnEachOther) {
  const StudyDesign design{.design = Design::latin_hypercube, .block_size = 8, .modes = 6};
  RandomFields among = designed(normal_strip(), design), single = designed(normal_strip(), design);
  for (std::uint32_t sample = 1; sample <= 12; ++sample) gaussian_of(among, sample, 36);
  EXPECT_EQ(gaussian_of(among, 13, 36), gaussian_of(single, 13, 36));
  EXPECT_EQ(gaussian_of(among, 3, 36), gaussian_of(single, 3, 36));
}

TEST(Design, NumbersItsBlocks) {
  EXPECT_EQ(block_of({}, 7), 7u);
  EXPECT_EQ(block_of({.design = Design::antithetic}, 1), 1u);
  EXPECT_EQ(block_of({.design = Design::antithetic}, 2), 1u);
  EXPECT_EQ(block_of({.design = Design::antithetic}, 3), 2u);
  EXPECT_EQ(block_of({.design = Design::latin_hypercube, .block_size = 16}, 16), 1u);
  EXPECT_EQ(block_of({.design = Design::latin_hypercube, .block_size = 16}, 17), 2u);
}

TEST(Design, HypercubeRefusesMeshesWhoseModesAreOutOfReach) {
  FieldModel large = model({0.1, 0.1, 100, 30}, Autocorrelation::single_exponential, 1, 1);
  const StudyDesign design{.design = Design::latin_hypercube};
  EXPECT_NO_THROW(designed(large, design));
  large.correlation.bedding_angle = 0.3;
  EXPECT_THROW(designed(large, design), Error);
}

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
  const FieldModel smooth = model({0.001, 0.001, 9, 4}, Autocorrelation::squared_exponential, 3, 1);
  EXPECT_EQ(message(smooth, {{3, 25e3, 0, "a"}, {4, 25e3, 0, "b"}, {5, 26e3, 0, "c"}, {6, 26e3, 0, "d"}}),
            "[field.cohesion]: the measurements lie too close together for this correlation; give them an error");
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
