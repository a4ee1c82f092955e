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

/// The standard normal of a measured value. One that the model has once in 10^9 cells says that the model or a unit is wrong.
double normal_of(const Measurement& measurement, const CellTransform& transform) {
  constexpr double largest = 6;
  const std::optional<double> normal = transform.normal(measurement.value, measurement.cell);
  if (!normal) fail(measurement, "found " + format_brief(measurement.value) + ", a value that the marginal distribution does not have");
  if (std::abs(*normal) > largest)
    fail(measurement, "found " + format_brief(measurement.value) +
                          ", a value that the marginal distribution has less than once in 10^9 cells; check its unit, mean and cov");
  return *normal;
}

/// The error of that normal.
double error_of(const Measurement& measurement, const CellTransform& transform, double normal) {
  if (measurement.error == 0) return 0;
  const double slope = transform.slope(normal, measurement.cell);
  if (!(slope > 0))
    fail(measurement, "found an error of " + format_brief(measurement.error) +
                          " at a value where the empirical distribution is level, so that it has no meaning; leave it out");
  return measurement.error / slope;
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

Conditioning::Conditioning(const FieldModel& model, const Eigen::MatrixXd& correlations, std::span<const ConditionedField> fields) {
  for (std::size_t field = 0; field < fields.size(); ++field)
    for (const Measurement& measurement : without_repetition(fields[field].measurements)) {
      const double normal = normal_of(measurement, fields[field].transform);
      data_.push_back({field, measurement.cell, normal, error_of(measurement, fields[field].transform, normal)});
    }
  const auto count = static_cast<Eigen::Index>(data_.size());
  const auto cells = static_cast<Eigen::Index>(model.mesh.size());
  check_memory(model.mesh.size() * fields.size(), data_.size());

  CellCorrelation correlation(model);
  Eigen::MatrixXd between_data(count, count), to_data(cells, count);
  const auto cross = [&](std::size_t a, std::size_t b) { return correlations(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)); };
  for (Eigen::Index i = 0; i < count; ++i) {
    const Datum& measured = data_[static_cast<std::size_t>(i)];
    for (Eigen::Index c = 0; c < cells; ++c) to_data(c, i) = covariance(correlation, model, static_cast<std::size_t>(c), measured.cell);
    for (Eigen::Index j = 0; j < count; ++j) {
      const Datum& other = data_[static_cast<std::size_t>(j)];
      between_data(i, j) = cross(measured.field, other.field) * covariance(correlation, model, measured.cell, other.cell);
    }
    between_data(i, i) += measured.error * measured.error;
  }
  const Eigen::LLT<Eigen::MatrixXd> cholesky(between_data);
  constexpr double least_condition = 1e-12;
  if (cholesky.info() != Eigen::Success || cholesky.rcond() < least_condition)
    throw Error(ExitCode::data, "the measurements lie too close together for this correlation; give them an error");
  for (std::size_t field = 0; field < fields.size(); ++field) {
    Eigen::VectorXd shares(count);
    for (Eigen::Index i = 0; i < count; ++i) shares(i) = cross(field, data_[static_cast<std::size_t>(i)].field);
    weights_.push_back(cholesky.solve((to_data * shares.asDiagonal()).transpose()).transpose());
  }
}

void Conditioning::apply(std::span<const std::span<double>> fields, std::span<const RandomStream> streams, double sign) const {
  static const std::uint32_t errors = purpose("measurement errors");
  Eigen::VectorXd residual(static_cast<Eigen::Index>(data_.size()));
  std::vector<double> normals;
  for (std::size_t i = 0, first = 0; i < data_.size(); ++i) {
    const Datum& datum = data_[i];
    if (i == 0 || data_[i - 1].field != datum.field) {
      const auto is_of_field = [&](const Datum& other) { return other.field == datum.field; };
      normals.resize(static_cast<std::size_t>(std::ranges::count_if(data_, is_of_field)));
      RandomStream stream = streams[datum.field];
      stream.purpose ^= errors;
      fill_normals(normals, stream);
      first = i;
    }
    residual(static_cast<Eigen::Index>(i)) = datum.target + datum.error * (sign * normals[i - first]) - fields[datum.field][datum.cell];
  }
  for (std::size_t field = 0; field < fields.size(); ++field)
    Eigen::Map<Eigen::VectorXd>(fields[field].data(), static_cast<Eigen::Index>(fields[field].size())).noalias() +=
        weights_[field] * residual;
}

}  // namespace slidezone
