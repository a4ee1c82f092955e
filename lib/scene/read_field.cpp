#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "scene/read_tables.hpp"
#include "scene/slope.hpp"

namespace slidezone {

static const Range coefficients_of_variation{.low = 0, .high = 10, .is_low_excluded = true};
static const Range smoothnesses{.low = 0, .high = 50, .is_low_excluded = true};
static const Range bedding_angles{.low = -std::numbers::pi / 2, .high = std::numbers::pi / 2};
static const Range nuggets{.low = 0, .high = 1, .is_high_excluded = true};
static const Range shares{.low = 0, .high = 1, .is_low_excluded = true};
static constexpr double most_cells = 1e8;  // of a field's mesh

static std::string kilopascals(double stress) { return format_brief(stress / 1000) + " kPa"; }

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

/// The value whose name, among `names` in the order of the enumeration, is the key's text.
template <class Value>
static Value named_or(const TomlTable& table, const std::string& key, const std::vector<std::string>& names, Value absent) {
  if (!table.has(key)) return absent;
  return static_cast<Value>(std::ranges::find(names, table.choice(key, names)) - names.begin());
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
static Marginal read_marginal(const TomlTable& table) {
  Marginal marginal;
  marginal.distribution = named_or(table, "marginal", distribution_names(), marginal.distribution);
  const bool is_empirical = marginal.distribution == Distribution::empirical;
  const bool has_ends = marginal.distribution == Distribution::truncated_normal || marginal.distribution == Distribution::beta;
  for (const char* key : {"mean", "cov"})
    if (is_empirical && table.has(key)) table.fail(key, "has no meaning with marginal = \"empirical\": the data say it");
  for (const char* key : {"low", "high"})
    if (!has_ends && table.has(key)) table.fail(key, "has a meaning only with marginal = \"truncated normal\" or \"beta\"");
  if (!is_empirical && table.has("data")) table.fail("data", "has a meaning only with marginal = \"empirical\"");
  if (is_empirical) {
    marginal.data = table.quantities("data", "Pa", positive, 2);
    return marginal;
  }
  marginal.mean = table.quantity("mean", "Pa", positive);
  marginal.cov = table.number("cov", coefficients_of_variation);
  if (!has_ends) return marginal;
  marginal.low = table.quantity("low", "Pa", not_negative);
  marginal.high = table.quantity("high", "Pa", positive);
  if (marginal.low >= marginal.mean) table.fail("low", "wants less than the mean");
  if (marginal.high <= marginal.mean) table.fail("high", "wants more than the mean");
  return marginal;
}

/// Strength never falls below the residual one: values below that floor are raised to it.
static void check_floor(const TomlTable& table, const Marginal& marginal, const std::vector<Layer>& layers) {
  const bool is_empirical = marginal.distribution == Distribution::empirical;
  const double center = is_empirical ? *std::ranges::max_element(marginal.data) : marginal.mean;
  for (const Layer& layer : layers)
    if (center <= layer.material.residual_cohesion)
      table.fail(is_empirical ? "data" : "mean", "wants more than the residual cohesion of soil \"" + layer.name + "\", " +
                                                     kilopascals(layer.material.residual_cohesion) + ", the floor of the field, found " +
                                                     (is_empirical ? "at most " : "") + kilopascals(center));
}

static FieldSpec read_cohesion(const TomlTable& table, const Slope& slope, const std::vector<Layer>& layers) {
  table.check_keys({"mean",
                    "cov",
                    "marginal",
                    "low",
                    "high",
                    "data",
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
  field.marginal = read_marginal(table);
  field.correlation = read_correlation(table);
  field.correlation_of = named_or(table, "correlation_of", correlation_of_names(), field.correlation_of);
  field.average = named_or(table, "average", average_names(), field.average);
  field.mesh = read_mesh(table, slope);
  field.method = named_or(table, "method", method_names(), field.method);
  if (table.has("variance_kept") && field.method != Method::karhunen_loeve)
    table.fail("variance_kept", "has a meaning only with method = \"Karhunen-Loeve\"");
  field.variance_kept = table.number_or("variance_kept", shares, field.variance_kept);
  check_floor(table, field.marginal, layers);
  const std::string measurements = table.has("measurements") ? table.text("measurements") : "";
  if (table.has("measurements") && measurements.empty()) table.fail("measurements", "wants the name of a file");
  return {"cohesion", field, named_or(table, "interpolation", interpolation_names(), Interpolation::cell), measurements};
}

std::vector<FieldSpec> read_fields(const TomlTable& table, const Slope& slope, const std::vector<Layer>& layers) {
  table.check_keys({"cohesion"});
  return {read_cohesion(table.table("cohesion"), slope, layers)};
}

}  // namespace slidezone
