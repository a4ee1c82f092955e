#include <algorithm>

#include "core/text.hpp"
#include "scene/read_tables.hpp"

namespace slidezone {

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
