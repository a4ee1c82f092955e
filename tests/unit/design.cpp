// Random fields: antithetic pairs and Latin hypercubes.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "field/conditioning.hpp"
#include "field/latin_hypercube.hpp"
#include "field/mesh_covariance.hpp"
#include "field/model.hpp"
#include "field/random_fields.hpp"
#include "field_models.hpp"

namespace slidezone {
namespace {

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

}  // namespace
}  // namespace slidezone
