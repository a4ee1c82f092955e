// Random fields that honour measurements: conditioning by kriging (Journel 1974).
//
// Measurements, each of one cell, become standard normals d by the inverse of the cell's transform; an error (standard
// deviation, of the value) becomes one of the normal by the transform's slope. A sample g of the Gaussian field becomes
//
//   g + W (d + e - g_d),   W = C_cd (C_dd + E)^-1,
//
// with the covariances C between cells and measured cells, nugget included, the errors' variances E on the diagonal, and e drawn
// from them. Mean and variance of the samples are those of simple kriging; a measurement without error is met to rounding.
//
// Correlated fields are conditioned together (simple cokriging): the covariance of field i and field j is R_ij C with the matrix R of
// their correlations (field/cross_correlation.hpp), so that a measurement of one tells of the others.
#pragma once

#include <Eigen/Dense>
#include <span>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "field/cell_transform.hpp"
#include "field/model.hpp"

namespace slidezone {

struct Measurement {
  std::size_t cell = 0;
  double value = 0;
  double error = 0;   // standard deviation; 0: met exactly
  std::string where;  // its place in a file, for messages
};

/// One field of those that are conditioned together.
struct ConditionedField {
  const CellTransform& transform;
  std::span<const Measurement> measurements;
};

class Conditioning {
 public:
  /// Fields of one model but for their marginals and trends, of the correlations R. Throws ExitCode::data for values that the marginal
  /// does not have, two exact values of one cell that differ, and measurements too close for the correlation to tell apart.
  Conditioning(const FieldModel& model, const Eigen::MatrixXd& correlations, std::span<const ConditionedField> fields);

  /// Conditions one sample of the standard Gaussian fields. The errors of a field's measurements are drawn by its stream; `sign` is
  /// that of all random numbers.
  void apply(std::span<const std::span<double>> fields, std::span<const RandomStream> streams, double sign) const;

 private:
  struct Datum {
    std::size_t field;
    std::size_t cell;
    double target;
    double error;  // standard deviation, of the normal
  };
  std::vector<Datum> data_;               // field by field
  std::vector<Eigen::MatrixXd> weights_;  // W of each field, one row a cell
};

}  // namespace slidezone
