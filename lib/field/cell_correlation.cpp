#include "field/cell_correlation.hpp"

#include "field/autocorrelation.hpp"

namespace slidezone {

/// The transform of a normal distribution is linear: it leaves correlations as they are.
static bool bends_correlation(const FieldModel& model) {
  return model.correlation_of == CorrelationOf::physical && model.marginal.distribution != Distribution::normal;
}

CellCorrelation::CellCorrelation(const FieldModel& model)
    : mesh_(model.mesh),
      correlation_(model.correlation),
      is_separable_(slidezone::is_separable(model.correlation) && !bends_correlation(model)) {
  if (bends_correlation(model)) nataf_.emplace(MarginalTransform(model.marginal));
}

double CellCorrelation::operator()(double i, double j) const {
  const double rho = autocorrelation(correlation_, i * mesh_.cell_x, j * mesh_.cell_y);
  return nataf_ ? nataf_->gaussian(rho) : rho;
}

}  // namespace slidezone
