// Correlation of the Gaussian field between the cells of a model's mesh.
#pragma once

#include <optional>

#include "field/model.hpp"
#include "field/nataf.hpp"

namespace slidezone {

class CellCorrelation {
 public:
  explicit CellCorrelation(const FieldModel& model);

  /// Between cells i columns and j rows apart, either sign; fractions are in place. Without the nugget.
  double operator()(double i, double j) const;

  /// Whether it is a product of one function of i and one of j.
  bool is_separable() const { return is_separable_; }

 private:
  FieldMesh mesh_;
  Correlation correlation_;
  std::optional<Nataf> nataf_;  // where the correlation given is that of the values
  bool is_separable_;
};

}  // namespace slidezone
