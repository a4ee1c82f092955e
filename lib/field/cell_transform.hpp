// From standard normals to the values of cells: the marginal distribution (field/marginal.hpp), and the trend of its mean with depth.
//
//   constant cov   value = h(g) mean(depth) / mean
//   constant sd    value = h(g) + mean(depth) - mean
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "field/marginal.hpp"
#include "field/model.hpp"

namespace slidezone {

class CellTransform {
 public:
  /// Throws as MarginalTransform does.
  explicit CellTransform(const FieldModel& model);

  const MarginalTransform& marginal() const { return marginal_; }

  /// What the trend makes of a value of the marginal distribution in a cell.
  double with_trend(double value, std::size_t cell) const;

  /// The standard normal of a cell's value, and the change of the value with it; see MarginalTransform.
  std::optional<double> normal(double value, std::size_t cell) const;
  double slope(double g, std::size_t cell) const;

  /// Standard normals, one a cell, become values, in place.
  void apply(std::span<double> values) const;

 private:
  MarginalTransform marginal_;
  std::vector<double> factors_;  // by cell; empty: 1
  std::vector<double> shifts_;   // by cell; empty: 0
};

}  // namespace slidezone
