// Models of random fields that the tests of lib/field share, and what holds samples against a covariance. Seeds are fixed; limits of
// ensemble tests lie four standard errors out, which a right sampler misses once in 16,000 seeds.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "field/gaussian_field.hpp"
#include "field/model.hpp"
#include "field/random_fields.hpp"

namespace slidezone {

inline constexpr Autocorrelation every_function[] = {
    Autocorrelation::single_exponential,
    Autocorrelation::squared_exponential,
    Autocorrelation::second_order_markov,
    Autocorrelation::third_order_markov,
    Autocorrelation::cosine_exponential,
    Autocorrelation::binary_noise,
    Autocorrelation::matern,
    Autocorrelation::spherical,
};

inline std::string name_of(Autocorrelation function) { return autocorrelation_names()[static_cast<std::size_t>(function)]; }

inline constexpr double smoothness = 1.1;  // of Matern, where it does not matter

inline FieldModel model(FieldMesh mesh, Autocorrelation function, double scale_x, double scale_y) {
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

inline FieldModel with_method(FieldModel model, Method method) {
  model.method = method;
  return model;
}

inline FieldModel elliptical(FieldModel model, double bedding_angle = 0) {
  model.correlation.shape = LagShape::elliptical;
  model.correlation.bedding_angle = bedding_angle;
  return model;
}

inline const FieldMesh strip{0.5, 0.25, 9, 4};

/// One field alone.
inline RandomFields alone(const FieldModel& model, double floor, std::uint64_t seed, std::vector<Measurement> measurements = {}) {
  return RandomFields({{"cohesion", model, {.low = floor}, false, std::move(measurements)}}, {}, seed);
}

inline std::vector<double> gaussian_sample(const FieldModel& model, RandomStream stream) {
  GaussianField field(model);
  std::vector<double> values(model.mesh.size());
  field.fill(values, stream);
  return values;
}

inline double largest_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Compares products of pairs of cells over n samples with the covariance; their standard error is sqrt((1 + rho^2) / n).
inline void expect_covariance(const FieldModel& model, const Eigen::MatrixXd& covariance, const std::string& what) {
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

/// The distribution of most tests, between 5 and 60 kPa where it has ends.
inline Marginal marginal(Distribution distribution, double cov) { return {distribution, 20e3, cov, 5e3, 60e3, {}}; }

}  // namespace slidezone
