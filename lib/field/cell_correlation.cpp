#include "field/cell_correlation.hpp"

#include <cmath>

#include "core/error.hpp"
#include "field/autocorrelation.hpp"
#include "field/local_average.hpp"

namespace slidezone {

/// The transform of a normal distribution is linear: it leaves correlations as they are.
static bool bends_correlation(const FieldModel& model) {
  return model.correlation_of == CorrelationOf::physical && model.marginal.distribution != Distribution::normal;
}

CellCorrelation::CellCorrelation(const FieldModel& model)
    : mesh_(model.mesh),
      correlation_(model.correlation),
      is_separable_(slidezone::is_separable(model.correlation) && !bends_correlation(model)),
      is_averaged_(model.average == Average::cell) {
  if (is_averaged_ && !is_separable_)
    throw Error(ExitCode::data, "averages over cells want a separable correlation of the Gaussian field, without bedding angle");
  if (bends_correlation(model)) nataf_.emplace(MarginalTransform(model.marginal));
}

double CellCorrelation::average_along(std::vector<double>& known, double length, double k) const {
  const auto lag = static_cast<std::size_t>(std::abs(k));
  while (known.size() <= lag)
    known.push_back(average_covariance(correlation_.function, correlation_.smoothness, length, static_cast<double>(known.size())));
  return known[lag];
}

double CellCorrelation::operator()(double i, double j) {
  if (is_averaged_)
    return average_along(along_x_, mesh_.cell_x / correlation_.horizontal_scale, i) *
           average_along(along_y_, mesh_.cell_y / correlation_.vertical_scale, j);
  const double rho = autocorrelation(correlation_, i * mesh_.cell_x, j * mesh_.cell_y);
  return nataf_ ? nataf_->gaussian(rho) : rho;
}

}  // namespace slidezone
