// rfgen: samples of a scene's random fields on the fields' meshes.
// Scene, and the measurements that it names ("slidezone-measurements 1") -> samples in an HDF5 file ("slidezone-fields 1").
//   rfgen pipelines/demo/scene.toml -n 24 -o fields.h5
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/progress.hpp"
#include "core/provenance.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "core/tool.hpp"
#include "field/random_fields.hpp"
#include "io/file.hpp"
#include "io/hdf5_image.hpp"
#include "io/table.hpp"
#include "scene/scene.hpp"
#include "scene/varied_soil.hpp"

namespace slidezone {
namespace {

struct Options {
  std::string scene;
  std::optional<std::uint64_t> count;  // absent: [study] realizations
  std::uint64_t first = 1;
  std::optional<std::uint64_t> seed;  // absent: [study] seed
  bool explain = false;
  std::string output = "-";
};

constexpr std::uint64_t last_sample = std::numeric_limits<std::uint32_t>::max();

const char* const manual =
    R"(Samples of a scene's random fields, one value per cell of each field's mesh.

A scene may have a field of cohesion, residual_cohesion, friction_angle, youngs_modulus and unit_weight or density: [field.cohesion] in
all soils, [soil.field.cohesion] in one alone, correlated by [field.cross_correlation], of a mean that changes with depth.
Samples are numbered from 1. Sample K depends on the scene's fields, the seed and K alone: it is the same whenever, wherever and with
whatever other samples it is drawn. The scene chooses autocorrelation, marginal distribution and method; --explain says what that comes
to. Where the scene names a table of measurements (data-schemas/measurements.json), every sample honours them. Cohesions and friction
angles below the least residual ones of the scene's soils are raised to them, friction angles above 89 degrees lowered, and counted.
The result is an HDF5 file; data-schemas/fields.json lists what it holds.)";

/// What is drawn: samples first ... first + count - 1.
struct Draw {
  std::uint64_t seed;
  std::uint64_t first;
  std::uint64_t count;
};

Draw draw_of(const Options& options, const Scene& scene) {
  const std::uint64_t count = options.count.value_or(scene.study.realizations);
  if (count > last_sample - options.first + 1)
    throw Error(ExitCode::usage, "samples are numbered up to " + std::to_string(last_sample) + "; lower --first or --count");
  return {options.seed.value_or(scene.study.seed), options.first, count};
}

/// Draws each sample when its turn to be written comes.
void write_samples(const Draw& draw, const Scene& scene, RandomFields& fields, Hdf5Writer& file, OutputFile& output) {
  Progress progress("rfgen", is_quiet() ? Progress::Show::never : Progress::Show::on_terminal);
  std::vector<std::int64_t> realizations(draw.count);
  std::iota(realizations.begin(), realizations.end(), static_cast<std::int64_t>(draw.first));
  std::vector<std::int64_t> blocks(draw.count), floored(draw.count);
  for (std::size_t k = 0; k < draw.count; ++k) blocks[k] = static_cast<std::int64_t>(block_of(scene.study.design, draw.first + k));

  std::vector<Hdf5Writer::LaterDataset> datasets;
  for (std::size_t i = 0; i < scene.fields.size(); ++i) {
    const FieldMesh& mesh = scene.fields[i].model.mesh;
    datasets.push_back({scene.fields[i].name,
                        {draw.count, static_cast<std::size_t>(mesh.cells_y), static_cast<std::size_t>(mesh.cells_x)},
                        [&, i](std::size_t k, std::span<double> values) {
                          const auto sample = static_cast<std::uint32_t>(draw.first + k);
                          floored[k] += static_cast<std::int64_t>(fields.fill(i, values, sample));
                          progress.update(static_cast<double>(k + 1) / static_cast<double>(draw.count), "sample " + std::to_string(sample));
                        }});
  }
  file.dataset("realization", realizations);
  file.dataset("block", blocks);
  file.datasets_later(datasets);
  for (const FieldSpec& spec : scene.fields) {
    file.attribute(spec.name, "unit", std::string(kind_of(spec.parameter).unit));
    file.attribute(spec.name, "cell_x", spec.model.mesh.cell_x);
    file.attribute(spec.name, "cell_y", spec.model.mesh.cell_y);
  }
  file.dataset_later("floored", draw.count,
                     [&](std::size_t, std::span<std::int64_t> values) { std::ranges::copy(floored, values.begin()); });
  file.write([&](std::string_view bytes) { output.write(bytes); });
}

/// What --explain prints of a field: the method, why, and what it costs in accuracy.
std::string explanation(const RandomFields& fields, std::size_t field, const StudyDesign& design) {
  const MethodReport& report = fields.report(field);
  const std::optional<LatinHypercube>& hypercube = fields.hypercube(field);
  return "method: " + report.method + "\nreason: " + report.reason + "\nlargest error of the covariance, of variance 1: " +
         (report.covariance_error > 0 ? format_brief(report.covariance_error, 2) : "rounding") +
         "\nshare of the variance kept: " + format_brief(report.variance_kept, 6) + "\n" +
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

/// One row of the table of measurements: its cell, and its value in SI units.
Measurement measurement_of(const Table& table, std::size_t row, const Scene& scene, const FieldSpec& spec) {
  const auto [ending, unit] = written_unit(spec.parameter);
  const std::string where = to_string(table.where(row));
  const double x = table.number(row, "x_m"), depth = table.number(row, "depth_m");
  const double error = table.has_column("error" + ending) ? table.number(row, "error" + ending) : 0;
  if (depth < 0 || error < 0) throw Error(ExitCode::data, where + ": depth and error want at least 0");
  const double y = elevation(scene.slope.surface, x) - depth;
  try {
    const std::size_t cell = containing_cells(spec.model.mesh, std::vector{x}, std::vector{y}).front();
    return {cell, unit * table.number(row, "value" + ending), unit * error, where};
  } catch (const Error& outside) {
    throw Error(outside.code(), where + ": " + outside.what());
  }
}

Conditions read_conditions(const Scene& scene, const FieldSpec& spec) {
  if (spec.measurements.empty()) return {};
  const std::string path = (std::filesystem::path(scene.name).parent_path() / spec.measurements).string();
  const std::string bytes = read_input(path);
  const std::vector<std::string> columns = {"x_m", "depth_m", "value" + written_unit(spec.parameter).first};
  const Table table = parse_tsv(bytes, path, "slidezone-measurements 1", columns);
  Conditions conditions{{}, checksum(bytes)};
  for (std::size_t row = 0; row < table.row_count(); ++row) conditions.measurements.push_back(measurement_of(table, row, scene, spec));
  return conditions;
}

/// The fields of a scene, and what their provenance says of measurements.
struct Sampler {
  RandomFields fields;
  std::vector<std::pair<std::string, std::string>> details;
};

Sampler sampler_of(const Scene& scene, const Draw& draw) {
  std::vector<FieldPlan> plans;
  std::vector<std::pair<std::string, std::string>> details;
  for (const FieldSpec& spec : scene.fields) {
    Conditions conditions = read_conditions(scene, spec);
    if (!conditions.checksum.empty())
      details.emplace_back(scene.fields.size() == 1 ? "measurements" : "measurements of " + spec.name, conditions.checksum);
    const bool is_strength = spec.parameter == Parameter::cohesion || spec.parameter == Parameter::residual_cohesion ||
                             spec.parameter == Parameter::friction_angle;
    plans.push_back({spec.name, spec.model, limits_of(spec, scene), !is_strength, std::move(conditions.measurements)});
  }
  try {
    return {RandomFields(std::move(plans), scene.cross_correlations, draw.seed, scene.study.design), std::move(details)};
  } catch (const Error& error) {
    throw Error(error.code(), scene.name + ": " + error.what());
  }
}

void run(const Options& options) {
  if (!options.explain) refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.soil = true, .field = true});
  const Draw draw = draw_of(options, scene);
  Sampler sampler = sampler_of(scene, draw);
  if (options.explain) return write_output(options.output, explanation(scene, sampler.fields));
  OutputFile output(options.output);
  Hdf5Writer file;
  Provenance origin = provenance("slidezone-fields 1", "rfgen");
  origin.details = {{"scene", scene.checksum}, {"seed", std::to_string(draw.seed)}, {"design", to_string(scene.study.design.design)}};
  origin.details.insert(origin.details.end(), sampler.details.begin(), sampler.details.end());
  file.provenance(origin);
  write_samples(draw, scene, sampler.fields, file, output);
  output.finish();
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  Options options;
  CLI::App app{manual, "rfgen"};
  app.add_option("scene", options.scene, "Scene (TOML); - is stdin")->required();
  app.add_option("-n,--count", options.count, "Number of samples (default: [study] realizations)")->check(whole_number(1, last_sample));
  app.add_option("--first", options.first, "Number of the first sample")->check(whole_number(1, last_sample))->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the study (default: [study] seed)")->check(whole_number(0));
  app.add_flag("--explain", options.explain, "Print which method makes the samples, why, and how exact it is; draw none");
  app.add_option("-o,--output", options.output, "Fields (HDF5); - is stdout")->capture_default_str();
  return tool_main(app, "rfgen pipelines/demo/scene.toml -n 24 -o fields.h5", argc, argv, [&] { run(options); });
}
