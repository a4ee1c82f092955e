#include "field/conditioning.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "field/cell_correlation.hpp"

namespace slidezone {

namespace {

[[noreturn]] void fail(const Measurement& measurement, const std::string& message) {
  throw Error(ExitCode::data, measurement.where + ": " + message);
}

/// Exact values of one cell must agree; the second of two equal ones is dropped.
std::vector<Measurement> without_repetition(std::span<const Measurement> measurements) {
  std::vector<Measurement> kept;
  for (const Measurement& measurement : measurements) {
    const auto same = std::ranges::find_if(
        kept, [&](const Measurement& other) { return other.cell == measurement.cell && other.error == 0 && measurement.error == 0; });
    if (same == kept.end())
      kept.push_back(measurement);
    else if (same->value != measurement.value)
      fail(measurement, "found " + format_brief(measurement.value) + ", but " + same->where + " gives the same cell " +
                            format_brief(same->value) + "; give them an error, or take a finer mesh");
  }
  return kept;
}

/// Covariance of two cells of the Gaussian field, nugget included.
double covariance(CellCorrelation& correlation, const FieldModel& model, std::size_t a, std::size_t b) {
  const auto columns = static_cast<std::size_t>(model.mesh.cells_x);
  const auto lag = [](std::size_t from, std::size_t to) { return static_cast<double>(to) - static_cast<double>(from); };
  const double nugget = model.correlation.nugget;
  return (1 - nugget) * correlation(lag(b % columns, a % columns), lag(b / columns, a / columns)) + (a == b ? nugget : 0);
}

void check_memory(std::size_t cells, std::size_t measurements) {
  constexpr double largest = 8e9;
  const double bytes = static_cast<double>(cells) * static_cast<double>(measurements) * sizeof(double);
  if (bytes > largest)
    throw Error(ExitCode::data, "conditioning " + std::to_string(cells) + " cells on " + std::to_string(measurements) +
                                    " measurements would take " + format_brief(std::ceil(bytes / 1e9), 15) +
                                    " GB of memory; take a coarser mesh");
}

}  // namespace

Conditioning::Conditioning(const FieldModel& model, const MarginalTransform& transform, std::span<const Measurement> measurements) {
  const std::vector<Measurement> used = without_repetition(measurements);
  const auto count = static_cast<Eigen::Index>(used.size());
  const auto cells = static_cast<Eigen::Index>(model.mesh.size());
  check_memory(model.mesh.size(), used.size());
  targets_.resize(count);
  errors_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Measurement& measurement = used[static_cast<std::size_t>(i)];
    const std::optional<double> normal = transform.normal(measurement.value);
    if (!normal) fail(measurement, "found " + format_brief(measurement.value) + ", a value that the marginal distribution does not have");
    targets_(i) = *normal;
    errors_(i) = measurement.error / transform.slope(*normal);
    cells_.push_back(measurement.cell);
  }

  CellCorrelation correlation(model);
  Eigen::MatrixXd between_data(count, count), to_data(cells, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t measured = cells_[static_cast<std::size_t>(i)];
    for (Eigen::Index c = 0; c < cells; ++c) to_data(c, i) = covariance(correlation, model, static_cast<std::size_t>(c), measured);
    for (Eigen::Index j = 0; j < count; ++j)
      between_data(i, j) = covariance(correlation, model, measured, cells_[static_cast<std::size_t>(j)]);
  }
  between_data.diagonal() += errors_.cwiseAbs2();
  const Eigen::LLT<Eigen::MatrixXd> cholesky(between_data);
  constexpr double least_condition = 1e-12;
  if (cholesky.info() != Eigen::Success || cholesky.rcond() < least_condition)
    throw Error(ExitCode::data, "the measurements lie too close together for this correlation; give them an error");
  weights_ = cholesky.solve(to_data.transpose()).transpose();
}

void Conditioning::apply(std::span<double> values, RandomStream stream) const {
  static const std::uint32_t errors = purpose("measurement errors");
  std::vector<double> normals(cells_.size());
  stream.purpose ^= errors;
  fill_normals(normals, stream);
  Eigen::VectorXd residual = targets_ + errors_.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(normals.data(), targets_.size()));
  for (std::size_t i = 0; i < cells_.size(); ++i) residual(static_cast<Eigen::Index>(i)) -= values[cells_[i]];
  Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())).noalias() += weights_ * residual;
}

}  // namespace slidezone
