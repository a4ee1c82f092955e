// Random fields that honour measurements: conditioning by kriging (Journel 1974).
//
// Measurements, each of one cell, become standard normals d by the inverse of the marginal's transform; an error (standard
// deviation, of the value) becomes one of the normal by the transform's slope. A sample g of the Gaussian field becomes
//
//   g + W (d + e - g_d),   W = C_cd (C_dd + E)^-1,
//
// with the covariances C between cells and measured cells, nugget included, the errors' variances E on the diagonal, and e drawn
// from them. Mean and variance of the samples are those of simple kriging; a measurement without error is met to rounding.
#pragma once

#include <Eigen/Dense>
#include <span>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "field/marginal.hpp"
#include "field/model.hpp"

namespace slidezone {

struct Measurement {
  std::size_t cell = 0;
  double value = 0;
  double error = 0;   // standard deviation; 0: met exactly
  std::string where;  // its place in a file, for messages
};

class Conditioning {
 public:
  /// Throws ExitCode::data for values that the marginal does not have, two exact values of one cell that differ, and measurements
  /// too close for the correlation to tell apart.
  Conditioning(const FieldModel& model, const MarginalTransform& transform, std::span<const Measurement> measurements);

  /// Conditions one standard Gaussian field.
  void apply(std::span<double> values, RandomStream stream) const;

 private:
  std::vector<std::size_t> cells_;
  Eigen::VectorXd targets_;
  Eigen::VectorXd errors_;   // standard deviations
  Eigen::MatrixXd weights_;  // W, one row a cell
};

}  // namespace slidezone
