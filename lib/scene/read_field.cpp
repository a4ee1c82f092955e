#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "scene/read_tables.hpp"
#include "scene/slope.hpp"
#include "scene/varied_soil.hpp"

namespace slidezone {

static const Range coefficients_of_variation{.low = 0, .high = 10, .is_low_excluded = true};
static const Range smoothnesses{.low = 0, .high = 50, .is_low_excluded = true};
static const Range bedding_angles{.low = -std::numbers::pi / 2, .high = std::numbers::pi / 2};
static const Range nuggets{.low = 0, .high = 1, .is_high_excluded = true};
static const Range shares{.low = 0, .high = 1, .is_low_excluded = true};
static constexpr double most_cells = 1e8;  // of a field's mesh

/// A value as scenes write it.
static std::string in_words(double value, Parameter parameter) {
  const std::string unit = kind_of(parameter).unit;
  if (unit == "rad") return format_brief(value * 180 / std::numbers::pi) + " deg";
  return unit == "Pa" ? format_brief(value / 1000) + " kPa" : format_brief(value) + " " + unit;
}

/// Cells of the size `cell` that cover `length`.
static double covering_cells(double length, double cell) { return std::max(1.0, std::ceil(length / cell * (1 - same_length))); }

static FieldMesh read_mesh(const TomlTable& table, const Slope& slope) {
  const Vec2 cell = table.quantity_pair("cell", "m", positive);
  const double cells_x = covering_cells(slope.surface.back().x, cell.x);
  const double cells_y = covering_cells(slope.crest.y, cell.y);
  if (cells_x * cells_y > most_cells)
    table.fail("cell", "divides the slope into more than " + format_real(most_cells) + " cells; make it larger");
  return {cell.x, cell.y, static_cast<int>(cells_x), static_cast<int>(cells_y)};
}

static Correlation read_correlation(const TomlTable& table) {
  Correlation correlation;
  correlation.function = named_or(table, "autocorrelation", autocorrelation_names(), correlation.function);
  if (correlation.function == Autocorrelation::matern)
    correlation.smoothness = table.number("smoothness", smoothnesses);
  else if (table.has("smoothness"))
    table.fail("smoothness", "has a meaning only with autocorrelation = \"Matern\"");
  correlation.horizontal_scale = table.quantity("horizontal_scale", "m", positive);
  correlation.vertical_scale = table.quantity("vertical_scale", "m", positive);
  correlation.shape = named_or(table, "lag", lag_shape_names(), correlation.shape);
  if (correlation.function == Autocorrelation::binary_noise && correlation.shape == LagShape::elliptical)
    table.fail("lag", "wants separable with autocorrelation = \"binary noise\": with an elliptical lag it is not positive definite");
  correlation.bedding_angle = table.quantity_or("bedding_angle", "rad", bedding_angles, correlation.bedding_angle);
  correlation.nugget = table.number_or("nugget", nuggets, correlation.nugget);
  return correlation;
}

/// Ends where the distribution has them, data where it is made of them; both have no place elsewhere.
static Marginal read_marginal(const TomlTable& table, const std::string& unit) {
  Marginal marginal;
  marginal.distribution = named_or(table, "marginal", distribution_names(), marginal.distribution);
  const bool is_empirical = marginal.distribution == Distribution::empirical;
  const bool has_ends = marginal.distribution == Distribution::truncated_normal || marginal.distribution == Distribution::beta;
  for (const char* key : {"mean", "cov", "mean_gradient"})
    if (is_empirical && table.has(key)) table.fail(key, "has no meaning with marginal = \"empirical\": the data say it");
  for (const char* key : {"low", "high"})
    if (!has_ends && table.has(key)) table.fail(key, "has a meaning only with marginal = \"truncated normal\" or \"beta\"");
  if (!is_empirical && table.has("data")) table.fail("data", "has a meaning only with marginal = \"empirical\"");
  if (is_empirical) {
    marginal.data = table.quantities("data", unit, positive, 2);
    return marginal;
  }
  marginal.mean = table.quantity("mean", unit, positive);
  marginal.cov = table.number("cov", coefficients_of_variation);
  if (!has_ends) return marginal;
  marginal.low = table.quantity("low", unit, not_negative);
  marginal.high = table.quantity("high", unit, positive);
  if (marginal.low >= marginal.mean) table.fail("low", "wants less than the mean");
  if (marginal.high <= marginal.mean) table.fail("high", "wants more than the mean");
  return marginal;
}

/// Depth of the cells' centres below the ground; 0 above it.
static std::vector<double> depths_of(const FieldMesh& mesh, const Slope& slope) {
  std::vector<double> depths;
  for (int j = 0; j < mesh.cells_y; ++j)
    for (int i = 0; i < mesh.cells_x; ++i)
      depths.push_back(std::max(0.0, elevation(slope.surface, (i + 0.5) * mesh.cell_x) - (j + 0.5) * mesh.cell_y));
  return depths;
}

/// The unit of a change with depth.
static std::string per_metre(const std::string& unit) {
  return unit.ends_with(" m-3") ? unit.substr(0, unit.size() - 1) + "4" : unit + " m-1";
}

static Trend read_trend(const TomlTable& table, const std::string& unit, const FieldModel& field, const Slope& slope) {
  Trend trend;
  if (!table.has("mean_gradient")) {
    if (table.has("spread")) table.fail("spread", "has a meaning only with a 'mean_gradient'");
    return trend;
  }
  trend.gradient = table.quantity("mean_gradient", per_metre(unit), any_number);
  trend.spread = named_or(table, "spread", spread_names(), trend.spread);
  trend.depth = depths_of(field.mesh, slope);
  return trend;
}

/// The least and the largest mean, at the surface and at the greatest depth. Of data, the largest item is both.
static std::pair<double, double> means_of(const FieldModel& field) {
  const Marginal& marginal = field.marginal;
  const double mean = marginal.distribution == Distribution::empirical ? *std::ranges::max_element(marginal.data) : marginal.mean;
  const double deepest = field.trend.depth.empty() ? 0 : *std::ranges::max_element(field.trend.depth);
  const double below = mean + field.trend.gradient * deepest;
  return {std::min(mean, below), std::max(mean, below)};
}

/// Strength never falls below the residual one, the floor of a field: values below are raised to it.
static void check_floor(const TomlTable& table, const FieldSpec& spec, const Layer& layer, double floor) {
  const bool is_empirical = spec.model.marginal.distribution == Distribution::empirical;
  const double least = means_of(spec.model).first;
  if (least > floor) return;
  const std::string key = kind_of(spec.parameter).name;
  table.fail(is_empirical ? "data" : "mean",
             "wants more than the residual " + (key == "cohesion" ? key : "friction angle") + " of soil \"" + layer.name + "\", " +
                 in_words(floor, spec.parameter) + ", the floor of the field, found " + (is_empirical ? "at most " : "") +
                 in_words(least, spec.parameter) + (spec.model.trend.depth.empty() ? "" : " at some depth"));
}

void check_values(const TomlTable& table, const FieldSpec& spec, const std::vector<Layer>& layers, bool has_residual_field) {
  const auto [least, largest] = means_of(spec.model);
  if (least <= 0) table.fail("mean_gradient", "wants a mean above 0 at every depth, found " + in_words(least, spec.parameter));
  if (spec.parameter == Parameter::friction_angle && largest >= largest_friction_angle)
    table.fail(table.has("mean") ? "mean" : "data", "wants below 89 deg, found " + in_words(largest, spec.parameter));
  for (const std::size_t soil : spec.soils) {
    const Layer& layer = layers[soil];
    if (spec.parameter == Parameter::cohesion && !has_residual_field) check_floor(table, spec, layer, least_cohesion(layer));
    if (spec.parameter == Parameter::friction_angle) check_floor(table, spec, layer, least_friction_angle(layer));
    if (spec.parameter == Parameter::residual_cohesion && layer.material.softening_shape == 0)
      fail_at(table.where(), "a field of residual cohesion has no effect in soil \"" + layer.name +
                                 "\", which does not soften: give the soil a softening_shape");
  }
}

static FieldModel read_model(const TomlTable& table, const std::string& unit, const Slope& slope) {
  table.check_keys({"mean",
                    "cov",
                    "marginal",
                    "low",
                    "high",
                    "data",
                    "mean_gradient",
                    "spread",
                    "autocorrelation",
                    "smoothness",
                    "horizontal_scale",
                    "vertical_scale",
                    "lag",
                    "bedding_angle",
                    "nugget",
                    "correlation_of",
                    "average",
                    "method",
                    "variance_kept",
                    "cell",
                    "interpolation",
                    "measurements"});
  FieldModel field;
  field.marginal = read_marginal(table, unit);
  field.correlation = read_correlation(table);
  field.correlation_of = named_or(table, "correlation_of", correlation_of_names(), field.correlation_of);
  field.average = named_or(table, "average", average_names(), field.average);
  field.mesh = read_mesh(table, slope);
  field.trend = read_trend(table, unit, field, slope);
  field.method = named_or(table, "method", method_names(), field.method);
  if (table.has("variance_kept") && field.method != Method::karhunen_loeve)
    table.fail("variance_kept", "has a meaning only with method = \"Karhunen-Loeve\"");
  field.variance_kept = table.number_or("variance_kept", shares, field.variance_kept);
  return field;
}

FieldSpec read_field(const TomlTable& table, Parameter parameter, const Slope& slope) {
  FieldSpec spec;
  spec.parameter = parameter;
  spec.name = kind_of(parameter).name;
  spec.model = read_model(table, kind_of(parameter).unit, slope);
  spec.interpolation = named_or(table, "interpolation", interpolation_names(), spec.interpolation);
  if (table.has("measurements")) spec.measurements = table.text("measurements");
  if (table.has("measurements") && spec.measurements.empty()) table.fail("measurements", "wants the name of a file");
  return spec;
}

}  // namespace slidezone
