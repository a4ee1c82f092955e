#include "sampling/field_check.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "field/cell_correlation.hpp"

namespace slidezone {

namespace {

constexpr double confidence = 0.99;  // of all rows together

struct Lag {
  int x, y;  // cells
};

/// One row: what theory says, and the numbers of the samples so far.
struct Row {
  std::string field;
  std::string quantity;
  Lag lag{0, 0};
  double theory = 0;
  double count = 0, mean = 0, squares = 0;  // Welford's sums

  void add(double number) {
    ++count;
    const double difference = number - mean;
    mean += difference / count;
    squares += difference * (number - mean);
  }
};

/// Cells of one axis at multiples of a scale of fluctuation, up to half the axis.
std::set<int> lags_along(double cell, double scale, int cells) {
  std::set<int> lags;
  for (const double multiple : {0.0, 0.125, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0}) {
    const int lag = std::max(1, static_cast<int>(std::lround(multiple * scale / cell)));
    if (2 * lag <= cells) lags.insert(lag);
  }
  return lags;
}

std::vector<Lag> lags_of(const FieldModel& model) {
  const std::set<int> along_x = lags_along(model.mesh.cell_x, model.correlation.horizontal_scale, model.mesh.cells_x);
  const std::set<int> along_y = lags_along(model.mesh.cell_y, model.correlation.vertical_scale, model.mesh.cells_y);
  std::vector<Lag> lags;
  for (const int lag : along_x) lags.push_back({lag, 0});
  for (const int lag : along_y) lags.push_back({0, lag});
  if (!along_x.empty() && !along_y.empty())
    for (const int sign : {1, -1}) lags.push_back({*std::next(along_x.begin(), along_x.size() / 2), sign * *along_y.begin()});
  return lags;
}

/// Variance of the Gaussian field at a cell, and its correlation at a lag.
double variance_of(const FieldModel& model) {
  const double nugget = model.correlation.nugget;
  return (1 - nugget) * CellCorrelation(model)(0, 0) + nugget;
}
double correlation_of(const FieldModel& model, Lag lag) {
  return (1 - model.correlation.nugget) * CellCorrelation(model)(lag.x, lag.y) / variance_of(model);
}

/// Mean over all pairs of cells a lag apart of the products of two fields.
double mean_product(const std::vector<double>& a, const std::vector<double>& b, const FieldMesh& mesh, Lag lag) {
  double sum = 0;
  for (int j = std::max(0, -lag.y); j < mesh.cells_y - std::max(0, lag.y); ++j) {
    const double* from = &a[static_cast<std::size_t>(j) * static_cast<std::size_t>(mesh.cells_x)];
    const double* to = &b[static_cast<std::size_t>(j + lag.y) * static_cast<std::size_t>(mesh.cells_x)] + lag.x;
    for (int i = 0; i < mesh.cells_x - lag.x; ++i) sum += from[i] * to[i];
  }
  return sum / ((mesh.cells_x - lag.x) * static_cast<double>(mesh.cells_y - std::abs(lag.y)));
}

/// What theory says of the values of a field: the mean of each cell, and the mean variance.
struct Moments {
  std::vector<double> means;
  double mean = 0;
  double variance = 0;
};

Moments moments_of(const FieldPlan& plan, const CellTransform& transform) {
  constexpr int per_unit = 64;
  const double sd = std::sqrt(variance_of(plan.model));
  std::vector<double> values, weights;
  for (int i = -8 * per_unit; i <= 8 * per_unit; ++i) {
    const double g = static_cast<double>(i) / per_unit;
    values.push_back(transform.marginal().value(sd * g));
    weights.push_back(std::exp(-g * g / 2) / std::sqrt(2 * std::numbers::pi) / per_unit);
  }
  const std::size_t cells = plan.model.mesh.size();
  const bool is_alike = plan.model.trend.depth.empty();
  Moments moments;
  for (std::size_t cell = 0; cell < (is_alike ? 1 : cells); ++cell) {
    double sum = 0, squares = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double value = std::clamp(transform.with_trend(values[k], cell), plan.limits.low, plan.limits.high);
      sum += weights[k] * value;
      squares += weights[k] * value * value;
    }
    moments.means.push_back(sum);
    moments.mean += sum;
    moments.variance += squares - sum * sum;
  }
  moments.mean /= static_cast<double>(moments.means.size());
  moments.variance /= static_cast<double>(moments.means.size());
  if (is_alike) moments.means.assign(cells, moments.mean);
  return moments;
}

/// The rows of one field, fed by its samples.
class FieldRows {
 public:
  FieldRows(const RandomFields& fields, std::size_t field)
      : plan_(fields.plan(field)), theory_(moments_of(plan_, fields.transform(field))) {
    rows_.push_back({plan_.name, "mean", {}, theory_.mean});
    rows_.push_back({plan_.name, "cov", {}, theory_.variance});
    for (const Lag lag : lags_of(plan_.model)) rows_.push_back({plan_.name, "correlation", lag, correlation_of(plan_.model, lag)});
  }

  void add(const std::vector<double>& gaussian, const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      sum += values[cell];
      squares += std::pow(values[cell] - theory_.means[cell], 2);
    }
    rows_[0].add(sum / static_cast<double>(values.size()));
    rows_[1].add(squares / static_cast<double>(values.size()));
    for (std::size_t i = 2; i < rows_.size(); ++i)
      rows_[i].add(mean_product(gaussian, gaussian, plan_.model.mesh, rows_[i].lag) / variance_of_gaussian_);
  }

  const std::vector<Row>& rows() const { return rows_; }
  double mean() const { return theory_.mean; }
  const FieldMesh& mesh() const { return plan_.model.mesh; }

 private:
  const FieldPlan& plan_;
  Moments theory_;
  double variance_of_gaussian_ = variance_of(plan_.model);
  std::vector<Row> rows_;
};

/// Correlations between two fields.
struct Pair {
  std::size_t a, b;
  Row row;
};

std::vector<Pair> pairs_of(const Scene& scene, const RandomFields& fields) {
  std::vector<Pair> pairs;
  for (const CrossCorrelation& correlated : scene.cross_correlations) {
    std::vector<MarginalTransform> transforms;
    for (const std::size_t field : correlated.fields) transforms.push_back(fields.transform(field).marginal());
    const Eigen::MatrixXd factor = mixing_of(correlated, transforms), matrix = factor * factor.transpose();
    for (std::size_t i = 0; i < correlated.fields.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const std::size_t a = correlated.fields[j], b = correlated.fields[i];
        pairs.push_back({a,
                         b,
                         {fields.plan(a).name + ", " + fields.plan(b).name,
                          "cross_correlation",
                          {},
                          matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))}});
      }
  }
  return pairs;
}

struct Interval {
  double low, high;
};

Interval interval_of(const Row& row, std::size_t rows) {
  const double tail = (1 - confidence) / (2 * static_cast<double>(rows));
  const double half = gsl_cdf_tdist_Qinv(tail, row.count - 1) * std::sqrt(row.squares / (row.count - 1) / row.count);
  return {row.mean - half, row.mean + half};
}

void add_to(Table& table, const Row& row, const FieldMesh& mesh, std::size_t rows, double mean) {
  const auto shown = [&](double number) { return format_real(row.quantity == "cov" ? std::sqrt(std::max(0.0, number)) / mean : number); };
  const Interval interval = interval_of(row, rows);
  // Rounding: where all samples give the same number, as a check of itself does, the interval has no width.
  const double rounding = 1e-9 * std::abs(row.theory);
  const bool agrees = row.theory >= interval.low - rounding && row.theory <= interval.high + rounding;
  table.add_row({row.field, row.quantity, format_brief(row.lag.x * mesh.cell_x, 12), format_brief(row.lag.y * mesh.cell_y, 12),
                 shown(row.theory), shown(row.mean), shown(interval.low), shown(interval.high), format_real(row.count),
                 agrees ? "yes" : "no"});
}

}  // namespace

std::string verdict_of(const Table& check) {
  std::size_t disagreeing = 0;
  for (std::size_t row = 0; row < check.row_count(); ++row) disagreeing += check.text(row, "agrees") == "no" ? 1 : 0;
  const std::string rows = std::to_string(check.row_count()) + " rows";
  return disagreeing == 0 ? "all " + rows + " agree" : std::to_string(disagreeing) + " of " + rows + " disagree";
}

Table field_check(const Scene& scene, RandomFields& fields, std::uint32_t first, std::size_t count,
                  const std::function<void(std::size_t)>& done) {
  std::vector<FieldRows> of_fields;
  for (std::size_t field = 0; field < scene.fields.size(); ++field) of_fields.emplace_back(fields, field);
  std::vector<Pair> pairs = pairs_of(scene, fields);
  std::vector<std::vector<double>> gaussian(scene.fields.size());
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t field = 0; field < scene.fields.size(); ++field) {
      gaussian[field].resize(of_fields[field].mesh().size());
      fields.fill_gaussian(field, gaussian[field], first + static_cast<std::uint32_t>(k));
      std::vector<double> values = gaussian[field];
      fields.make_values(field, values);
      of_fields[field].add(gaussian[field], values);
    }
    for (Pair& pair : pairs)
      pair.row.add(mean_product(gaussian[pair.a], gaussian[pair.b], of_fields[pair.a].mesh(), {0, 0}) /
                   variance_of(fields.plan(pair.a).model));
    done(k + 1);
  }

  std::size_t rows = pairs.size();
  for (const FieldRows& of_field : of_fields) rows += of_field.rows().size();
  Table table({"field", "quantity", "lag_x_m", "lag_y_m", "theory", "estimate", "ci_low", "ci_high", "samples", "agrees"});
  for (const FieldRows& of_field : of_fields)
    for (const Row& row : of_field.rows()) add_to(table, row, of_field.mesh(), rows, of_field.mean());
  for (const Pair& pair : pairs) add_to(table, pair.row, of_fields[pair.a].mesh(), rows, 1);
  return table;
}

}  // namespace slidezone
