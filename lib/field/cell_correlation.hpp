// Covariance of the Gaussian field between the cells of a model's mesh: at their centres, or averaged over them.
//
// Averages over cells keep a separable covariance separable: it is the product of that of either axis (field/local_average.hpp).
// Their variance is below 1. Values made of them are, for a lognormal, geometric averages over the cell.
#pragma once

#include <optional>
#include <vector>

#include "field/model.hpp"
#include "field/nataf.hpp"

namespace slidezone {

class CellCorrelation {
 public:
  /// Throws ExitCode::data for averages of a field that is not separable.
  explicit CellCorrelation(const FieldModel& model);

  /// Between cells i columns and j rows apart, either sign. Without the nugget.
  double operator()(double i, double j);

  /// Whether it is a product of one function of i and one of j.
  bool is_separable() const { return is_separable_; }

 private:
  double average_along(std::vector<double>& known, double length, double k) const;

  FieldMesh mesh_;
  Correlation correlation_;
  std::optional<Nataf> nataf_;  // where the correlation given is that of the values
  bool is_separable_;
  bool is_averaged_;
  std::vector<double> along_x_;  // covariances of averages, filled as far as asked for
  std::vector<double> along_y_;
};

}  // namespace slidezone
