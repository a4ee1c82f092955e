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

/// Whether values can be those of the soils that the field applies to.
static void check_values(const TomlTable& table, const FieldSpec& spec, const std::vector<Layer>& layers, bool has_residual_field) {
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

static FieldSpec read_field(const TomlTable& table, Parameter parameter, const Slope& slope) {
  FieldSpec spec;
  spec.parameter = parameter;
  spec.name = kind_of(parameter).name;
  spec.model = read_model(table, kind_of(parameter).unit, slope);
  spec.interpolation = named_or(table, "interpolation", interpolation_names(), spec.interpolation);
  if (table.has("measurements")) spec.measurements = table.text("measurements");
  if (table.has("measurements") && spec.measurements.empty()) table.fail("measurements", "wants the name of a file");
  return spec;
}

/// Why the fields of two parameters cannot be mixed; empty where they can.
static std::string difference(const FieldModel& a, const FieldModel& b) {
  if (a.mesh != b.mesh) return "mesh";
  if (a.correlation != b.correlation) return "autocorrelation";
  if (a.correlation_of == CorrelationOf::physical || b.correlation_of == CorrelationOf::physical)
    return "autocorrelation behind the values (correlation_of = \"physical\")";
  if (a.average != b.average) return "average";
  return a.method != b.method || a.variance_kept != b.variance_kept ? "method" : "";
}

/// The fields that the names say, which must be of one table [field] and can be mixed.
static std::vector<std::size_t> correlated_fields(const TomlTable& table, const std::vector<FieldSpec>& fields, std::size_t first) {
  std::vector<std::size_t> found;
  std::vector<std::string> known;
  for (std::size_t i = first; i < fields.size(); ++i) known.push_back(kind_of(fields[i].parameter).name);
  for (const std::string& name : table.texts("parameters", 2)) {
    const auto place = std::ranges::find(known, name);
    const std::size_t item = found.size();
    if (place == known.end())
      table.fail("parameters", item, "wants parameters of fields beside it, found \"" + name + '"' + nearest_hint(name, known));
    const std::size_t field = first + static_cast<std::size_t>(place - known.begin());
    if (std::ranges::find(found, field) != found.end()) table.fail("parameters", item, "has \"" + name + "\" twice");
    found.push_back(field);
    const std::string differs = difference(fields[found.front()].model, fields[field].model);
    if (!differs.empty())
      table.fail("parameters", item,
                 "wants fields that share mesh, autocorrelation, average and method, but those of \"" +
                     std::string(kind_of(fields[found.front()].parameter).name) + "\" and \"" + name + "\" differ in their " + differs);
  }
  return found;
}

static CrossCorrelation read_cross_correlation(const TomlTable& table, const std::vector<FieldSpec>& fields, std::size_t first) {
  table.check_keys({"parameters", "matrix", "correlation_of"});
  CrossCorrelation correlated;
  correlated.fields = correlated_fields(table, fields, first);
  correlated.matrix = table.matrix("matrix", {.low = -1, .high = 1}, 2);
  correlated.correlation_of = named_or(table, "correlation_of", correlation_of_names(), correlated.correlation_of);
  const auto& matrix = correlated.matrix;
  if (matrix.size() != correlated.fields.size())
    table.fail("matrix", "wants a row for each of the " + std::to_string(correlated.fields.size()) + " parameters, found " +
                             std::to_string(matrix.size()));
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    if (matrix[i][i] != 1) table.fail("matrix", i, "wants ones on its diagonal, found " + format_brief(matrix[i][i]));
    for (std::size_t j = 0; j < i; ++j)
      if (matrix[i][j] != matrix[j][i])
        table.fail("matrix", i, "wants to be symmetric, found " + format_brief(matrix[i][j]) + " and " + format_brief(matrix[j][i]));
  }
  if (correlated.correlation_of == CorrelationOf::gaussian)
    if (const std::string flaw = flaw_of_correlations(matrix); !flaw.empty()) table.fail("matrix", flaw);
  return correlated;
}

/// One table [field] or [soil.field]: its fields are those from `first` on.
static void append_fields(const TomlTable& table, const Slope& slope, Fields& fields) {
  std::vector<std::string> known;
  for (const ParameterKind& kind : parameter_kinds) known.emplace_back(kind.name);
  const std::string list = list_of(known);
  known.emplace_back("cross_correlation");
  table.check_keys(known);
  const std::size_t first = fields.specs.size();
  for (std::size_t i = 0; i < parameter_kinds.size(); ++i)
    if (table.has(parameter_kinds[i].name))
      fields.specs.push_back(read_field(table.table(parameter_kinds[i].name), static_cast<Parameter>(i), slope));
  if (fields.specs.size() == first) fail_at(table.where(), "a table of random fields wants at least one of " + list);
  if (table.has("cross_correlation"))
    fields.cross_correlations.push_back(read_cross_correlation(table.table("cross_correlation"), fields.specs, first));
}

/// Density and unit weight are one parameter under two names; all fields of a scene use one of them.
static void check_weights(const std::vector<FieldSpec>& fields, const std::vector<TomlTable>& places) {
  const auto place_of = [&](Parameter parameter) { return std::ranges::find(fields, parameter, &FieldSpec::parameter) - fields.begin(); };
  const auto count = static_cast<std::ptrdiff_t>(fields.size());
  const std::ptrdiff_t density = place_of(Parameter::density), unit_weight = place_of(Parameter::unit_weight);
  if (density < count && unit_weight < count)
    fail_at(places[static_cast<std::size_t>(density)].where(), "a field of density cannot stand beside one of unit weight; give either");
}

static bool has_field(const std::vector<FieldSpec>& fields, Parameter parameter, std::size_t soil) {
  return std::ranges::any_of(fields, [&](const FieldSpec& spec) {
    return spec.parameter == parameter && std::ranges::find(spec.soils, soil) != spec.soils.end();
  });
}

/// Fields of all soils go to those that have none of their own.
static void share_out(const TomlTable& table, std::vector<FieldSpec>& fields, std::size_t count, std::size_t soils) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t soil = 0; soil < soils; ++soil)
      if (!has_field(fields, fields[i].parameter, soil)) fields[i].soils.push_back(soil);
    if (fields[i].soils.empty() && soils > 0)
      table.fail(kind_of(fields[i].parameter).name, "has no use: every soil has a field of its own");
  }
}

Fields read_fields(const TomlTable& file, const Slope& slope, const std::vector<Layer>& layers) {
  Fields fields;
  std::vector<TomlTable> places;  // of each field
  const auto append = [&](const TomlTable& table) {
    append_fields(table, slope, fields);
    for (std::size_t i = places.size(); i < fields.specs.size(); ++i)
      places.push_back(table.table(kind_of(fields.specs[i].parameter).name));
  };
  if (file.has("field")) append(file.table("field"));
  const std::size_t common = fields.specs.size();
  const std::vector<TomlTable> soils = file.has("soil") ? file.tables("soil") : std::vector<TomlTable>{};
  for (std::size_t soil = 0; soil < layers.size(); ++soil) {
    if (!soils[soil].has("field")) continue;
    if (layers[soil].name.find('/') != std::string::npos)
      soils[soil].fail("name", "wants no '/' in a soil with a field of its own, found \"" + layers[soil].name + "\": it names datasets");
    append(soils[soil].table("field"));
    for (FieldSpec& spec : fields.specs) {
      if (!spec.soils.empty() || &spec < &fields.specs[common]) continue;
      spec.soils = {soil};
      spec.name += "." + layers[soil].name;
    }
  }
  check_weights(fields.specs, places);
  if (common > 0) share_out(file.table("field"), fields.specs, common, layers.size());
  for (std::size_t i = 0; i < fields.specs.size(); ++i) {
    const FieldSpec& spec = fields.specs[i];
    const bool has_residual =
        std::ranges::all_of(spec.soils, [&](std::size_t soil) { return has_field(fields.specs, Parameter::residual_cohesion, soil); });
    check_values(places[i], spec, layers, has_residual);
  }
  return fields;
}

}  // namespace slidezone
