// Random fields: methods that make Gaussian samples, and their guards of positive definiteness.
#include "field/gaussian_field.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "field/circulant.hpp"
#include "field/covariance_factor.hpp"
#include "field/exponential.hpp"
#include "field/karhunen_loeve.hpp"
#include "field/mesh.hpp"
#include "field/mesh_covariance.hpp"
#include "field/model.hpp"
#include "field_models.hpp"

namespace slidezone {
namespace {

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

TEST(Guards, SmallMeshesTurnToCholeskyBeforeLongPadding) {
  const FieldModel wide = elliptical(model({0.5, 0.5, 9, 8}, Autocorrelation::squared_exponential, 3e4, 2e4), 0.3);
  EXPECT_EQ(GaussianField(wide).report().method, "Cholesky");
}

TEST(Guards, NoMethodClipsWhatIsNoCovariance) {
  // The Nataf model of this smooth correlation between values of a wide lognormal has eigenvalues well below 0.
  FieldModel impossible = model({1, 1, 10, 5}, Autocorrelation::squared_exponential, 4, 3);
  impossible.correlation_of = CorrelationOf::physical;
  impossible.marginal.cov = 3;
  ASSERT_LT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full_covariance(impossible)).eigenvalues()(0), -1e-3);
  for (const Method method : {Method::automatic, Method::cholesky, Method::karhunen_loeve})
    EXPECT_THROW(GaussianField(with_method(impossible, method)), Error) << method_names()[static_cast<std::size_t>(method)];
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

}  // namespace
}  // namespace slidezone
