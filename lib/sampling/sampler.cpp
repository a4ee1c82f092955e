#include "sampling/sampler.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"
#include "io/file.hpp"
#include "io/table.hpp"
#include "scene/soil_at.hpp"
#include "scene/varied_soil.hpp"

namespace slidezone {

namespace {

/// What samples must honour, and the checksum of the table that says it; empty where there is none.
struct Conditions {
  std::vector<Measurement> measurements;
  std::string checksum;
};

/// How a table of measurements writes the values of a parameter: the end of its columns' names, and that unit in SI.
std::pair<std::string, double> written_unit(Parameter parameter) {
  const std::string unit = kind_of(parameter).unit;
  if (unit == "rad") return {"_deg", std::numbers::pi / 180};
  if (unit == "N m-3") return {"_kN_m3", 1000};
  return unit == "Pa" ? std::pair<std::string, double>{"_kPa", 1000} : std::pair<std::string, double>{"_kg_m3", 1};
}

std::size_t cell_of(const FieldMesh& mesh, double x, double y, const std::string& where) {
  try {
    return containing_cells(mesh, std::vector{x}, std::vector{y}).front();
  } catch (const Error& outside) {
    throw Error(outside.code(), where + ": " + outside.what());
  }
}

/// A column of errors under another name would be taken for none, and its values be met exactly.
void check_columns(const Table& table, const std::string& ending) {
  for (const std::string& column : table.columns())
    if (column.starts_with("error") && column != "error" + ending)
      throw Error(ExitCode::data, to_string(table.header()) + ": found the column '" + column + "', expected 'error" + ending + "'");
}

/// A measurement beyond the limits of the field would be moved to them in every sample.
void check_limits(const Measurement& measurement, const Limits& limits) {
  if (measurement.error == 0 && (measurement.value < limits.low || measurement.value > limits.high))
    throw Error(ExitCode::data, measurement.where + ": found " + format_brief(measurement.value) +
                                    ", which no sample can honour: values of this field are held between " + format_brief(limits.low) +
                                    " and " + format_brief(limits.high));
}

/// One row of the table of measurements: its cell, and its value in SI units; nothing where its soil has no use of the field.
std::optional<Measurement> measurement_of(const Table& table, std::size_t row, const Scene& scene, const FieldSpec& spec) {
  const auto [ending, unit] = written_unit(spec.parameter);
  const std::string where = to_string(table.where(row));
  const double x = table.number(row, "x_m"), depth = table.number(row, "depth_m");
  const double error = table.has_column("error" + ending) ? table.number(row, "error" + ending) : 0;
  if (depth < 0 || error < 0) throw Error(ExitCode::data, where + ": depth and error want at least 0");
  const double y = elevation(scene.slope.surface, x) - depth;
  const Measurement measurement{cell_of(spec.model.mesh, x, y, where), unit * table.number(row, "value" + ending), unit * error, where};
  if (std::ranges::find(spec.soils, soil_at(scene.layers, x, y)) == spec.soils.end()) return std::nullopt;
  check_limits(measurement, limits_of(spec, scene));
  return measurement;
}

Conditions read_conditions(const Scene& scene, const FieldSpec& spec) {
  if (spec.measurements.empty()) return {};
  const std::string path = (std::filesystem::path(scene.name).parent_path() / spec.measurements).string();
  const std::string bytes = read_input(path);
  const std::vector<std::string> columns = {"x_m", "depth_m", "value" + written_unit(spec.parameter).first};
  const Table table = parse_tsv(bytes, path, "slidezone-measurements 1", columns);
  check_columns(table, written_unit(spec.parameter).first);
  Conditions conditions{{}, checksum(bytes)};
  for (std::size_t row = 0; row < table.row_count(); ++row)
    if (std::optional<Measurement> measurement = measurement_of(table, row, scene, spec))
      conditions.measurements.push_back(std::move(*measurement));
  if (conditions.measurements.empty())
    throw Error(ExitCode::data, path + ": found no measurement in the soils that have the field " + spec.name);
  return conditions;
}

bool is_strength(Parameter parameter) {
  return parameter == Parameter::cohesion || parameter == Parameter::residual_cohesion || parameter == Parameter::friction_angle;
}

FieldPlan plan_of(const Scene& scene, const FieldSpec& spec) {
  return {spec.name, spec.model, limits_of(spec, scene), !is_strength(spec.parameter), {}};
}

RandomFields fields_of(const Scene& scene, std::vector<FieldPlan> plans, std::uint64_t seed, const StudyDesign& design) {
  try {
    return RandomFields(std::move(plans), scene.cross_correlations, seed, design);
  } catch (const Error& error) {
    throw Error(error.code(), scene.name + ": " + error.what());
  }
}

}  // namespace

Sampler sampler_of(const Scene& scene, std::uint64_t seed) {
  std::vector<FieldPlan> plans;
  std::vector<std::pair<std::string, std::string>> details;
  for (const FieldSpec& spec : scene.fields) {
    Conditions conditions = read_conditions(scene, spec);
    if (!conditions.checksum.empty())
      details.emplace_back(scene.fields.size() == 1 ? "measurements" : "measurements of " + spec.name, conditions.checksum);
    plans.push_back(plan_of(scene, spec));
    plans.back().measurements = std::move(conditions.measurements);
  }
  return {fields_of(scene, std::move(plans), seed, scene.study.design), std::move(details)};
}

RandomFields plain_fields_of(const Scene& scene, std::uint64_t seed) {
  std::vector<FieldPlan> plans;
  for (const FieldSpec& spec : scene.fields) plans.push_back(plan_of(scene, spec));
  return fields_of(scene, std::move(plans), seed, {});
}

static std::string explanation(const RandomFields& fields, std::size_t field, const StudyDesign& design) {
  const MethodReport& report = fields.report(field);
  const std::optional<LatinHypercube>& hypercube = fields.hypercube(field);
  const std::size_t measurements = fields.plan(field).measurements.size();
  return "method: " + report.method + "\nreason: " + report.reason + "\nlargest error of the covariance, of variance 1: " +
         (report.covariance_error > 0 ? format_brief(report.covariance_error, 2) : "rounding") +
         "\nshare of the variance kept: " + format_brief(report.variance_kept, 6) + "\n" +
         (measurements > 0 ? "measurements honoured: " + std::to_string(measurements) + "\n" : "") +
         (hypercube
              ? "Latin hypercube: blocks of " + std::to_string(design.block_size) + " samples on " + std::to_string(hypercube->modes()) +
                    " modes, which hold " + format_brief(hypercube->variance_share(), 3) + " of the variance\n"
              : "");
}

/// Of one field, or of several, each after its name.
std::string explanation(const Scene& scene, const RandomFields& fields) {
  if (scene.fields.size() == 1) return explanation(fields, 0, scene.study.design);
  std::string text;
  for (std::size_t i = 0; i < scene.fields.size(); ++i)
    text += (i > 0 ? "\nfield: " : "field: ") + scene.fields[i].name + "\n" + explanation(fields, i, scene.study.design);
  return text;
}

}  // namespace slidezone
