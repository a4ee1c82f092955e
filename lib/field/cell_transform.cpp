#include "field/cell_transform.hpp"

namespace slidezone {

CellTransform::CellTransform(const FieldModel& model) : marginal_(model.marginal) {
  const double mean = model.marginal.mean;
  for (const double depth : model.trend.depth) {
    const double change = model.trend.gradient * depth;
    if (model.trend.spread == Spread::constant_cov)
      factors_.push_back((mean + change) / mean);
    else
      shifts_.push_back(change);
  }
}

double CellTransform::with_trend(double value, std::size_t cell) const {
  if (!factors_.empty()) return value * factors_[cell];
  return shifts_.empty() ? value : value + shifts_[cell];
}

std::optional<double> CellTransform::normal(double value, std::size_t cell) const {
  if (!factors_.empty()) return marginal_.normal(value / factors_[cell]);
  return marginal_.normal(shifts_.empty() ? value : value - shifts_[cell]);
}

double CellTransform::slope(double g, std::size_t cell) const {
  return factors_.empty() ? marginal_.slope(g) : marginal_.slope(g) * factors_[cell];
}

void CellTransform::apply(std::span<double> values) const {
  marginal_.apply(values);
  for (std::size_t cell = 0; cell < factors_.size(); ++cell) values[cell] *= factors_[cell];
  for (std::size_t cell = 0; cell < shifts_.size(); ++cell) values[cell] += shifts_[cell];
}

}  // namespace slidezone
