// rfgen: samples of a scene's random field on the field's mesh.
// Scene, and the measurements that it names ("slidezone-measurements 1") -> samples in an HDF5 file ("slidezone-fields 1").
//   rfgen pipelines/demo/scene.toml -n 24 -o fields.h5
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/progress.hpp"
#include "core/provenance.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "core/tool.hpp"
#include "field/random_field.hpp"
#include "io/file.hpp"
#include "io/hdf5_image.hpp"
#include "io/table.hpp"
#include "scene/scene.hpp"

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
    R"(Samples of a scene's random field [field.cohesion], one value per cell of the field's mesh.

Samples are numbered from 1. Sample K depends on the scene's field, the seed and K alone: it is the same whenever, wherever and with
whatever other samples it is drawn. The scene chooses autocorrelation, marginal distribution and method; --explain says what that comes
to. Where the scene names a table of measurements (data-schemas/measurements.json), every sample honours them. Values below the least
residual cohesion of the scene's soils are raised to it and counted.
The result is an HDF5 file; data-schemas/fields.json lists what it holds.)";

/// The strength below which no soil of the scene can fall.
double least_residual(const Scene& scene) {
  double least = std::numeric_limits<double>::infinity();
  for (const Layer& layer : scene.layers) least = std::min(least, layer.material.residual_cohesion);
  return least;
}

/// What is drawn: samples first ... first + count - 1 of a field.
struct Draw {
  const FieldSpec& spec;
  double floor;
  std::uint64_t seed;
  std::uint64_t first;
  std::uint64_t count;
};

Draw draw_of(const Options& options, const Scene& scene) {
  const FieldSpec& spec = scene.fields.front();
  const std::uint64_t count = options.count.value_or(scene.study.realizations);
  if (count > last_sample - options.first + 1)
    throw Error(ExitCode::usage, "samples are numbered up to " + std::to_string(last_sample) + "; lower --first or --count");
  return {spec, least_residual(scene), options.seed.value_or(scene.study.seed), options.first, count};
}

/// Draws each sample when its turn to be written comes.
void write_samples(const Draw& draw, RandomField& field, Hdf5Writer& file, OutputFile& output) {
  Progress progress("rfgen", is_quiet() ? Progress::Show::never : Progress::Show::on_terminal);
  const std::string& parameter = draw.spec.parameter;
  const FieldMesh& mesh = draw.spec.model.mesh;
  std::vector<std::int64_t> realizations(draw.count);
  std::iota(realizations.begin(), realizations.end(), static_cast<std::int64_t>(draw.first));
  std::vector<std::int64_t> floored(draw.count);

  file.dataset("realization", realizations);
  file.dataset_later(parameter, {draw.count, static_cast<std::size_t>(mesh.cells_y), static_cast<std::size_t>(mesh.cells_x)},
                     [&](std::size_t i, std::span<double> values) {
                       const auto sample = static_cast<std::uint32_t>(draw.first + i);
                       floored[i] = static_cast<std::int64_t>(field.fill_sample(values, {draw.seed, purpose(parameter), sample}));
                       progress.update(static_cast<double>(i + 1) / static_cast<double>(draw.count), "sample " + std::to_string(sample));
                     });
  file.attribute(parameter, "unit", std::string("Pa"));
  file.attribute(parameter, "cell_x", mesh.cell_x);
  file.attribute(parameter, "cell_y", mesh.cell_y);
  file.dataset_later("floored", draw.count,
                     [&](std::size_t, std::span<std::int64_t> values) { std::ranges::copy(floored, values.begin()); });
  file.write([&](std::string_view bytes) { output.write(bytes); });
}

/// What --explain prints: the method, why, and what it costs in accuracy.
std::string explanation(const MethodReport& report) {
  return "method: " + report.method + "\nreason: " + report.reason + "\nlargest error of the covariance, of variance 1: " +
         (report.covariance_error > 0 ? format_brief(report.covariance_error, 2) : "rounding") +
         "\nshare of the variance kept: " + format_brief(report.variance_kept, 6) + "\n";
}

/// What samples must honour, and the checksum of the table that says it; empty where there is none.
struct Conditions {
  std::vector<Measurement> measurements;
  std::string checksum;
};

/// One row of the table of measurements: its cell, and its value in Pa.
Measurement measurement_of(const Table& table, std::size_t row, const Scene& scene, const FieldMesh& mesh) {
  const std::string where = to_string(table.where(row));
  const double x = table.number(row, "x_m"), depth = table.number(row, "depth_m");
  const double error = table.has_column("error_kPa") ? table.number(row, "error_kPa") : 0;
  if (depth < 0 || error < 0) throw Error(ExitCode::data, where + ": depth and error want at least 0");
  const double y = elevation(scene.slope.surface, x) - depth;
  try {
    const std::size_t cell = containing_cells(mesh, std::vector{x}, std::vector{y}).front();
    return {cell, 1000 * table.number(row, "value_kPa"), 1000 * error, where};
  } catch (const Error& outside) {
    throw Error(outside.code(), where + ": " + outside.what());
  }
}

Conditions read_conditions(const Scene& scene, const FieldSpec& spec) {
  if (spec.measurements.empty()) return {};
  const std::string path = (std::filesystem::path(scene.name).parent_path() / spec.measurements).string();
  const std::string bytes = read_input(path);
  const std::vector<std::string> columns = {"x_m", "depth_m", "value_kPa"};
  const Table table = parse_tsv(bytes, path, "slidezone-measurements 1", columns);
  Conditions conditions{{}, checksum(bytes)};
  for (std::size_t row = 0; row < table.row_count(); ++row)
    conditions.measurements.push_back(measurement_of(table, row, scene, spec.model.mesh));
  return conditions;
}

/// The sampler of the scene's field; errors name the scene and the field.
RandomField field_of(const Draw& draw, const Scene& scene, std::span<const Measurement> measurements) {
  try {
    return RandomField(draw.spec.model, draw.floor, measurements);
  } catch (const Error& error) {
    throw Error(error.code(), scene.name + ": [field." + draw.spec.parameter + "]: " + error.what());
  }
}

void run(const Options& options) {
  if (!options.explain) refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.soil = true, .field = true});
  const Draw draw = draw_of(options, scene);
  const Conditions conditions = read_conditions(scene, draw.spec);
  RandomField field = field_of(draw, scene, conditions.measurements);
  if (options.explain) return write_output(options.output, explanation(field.report()));
  OutputFile output(options.output);
  Hdf5Writer file;
  Provenance origin = provenance("slidezone-fields 1", "rfgen");
  origin.details = {{"scene", scene.checksum}, {"seed", std::to_string(draw.seed)}};
  if (!conditions.checksum.empty()) origin.details.emplace_back("measurements", conditions.checksum);
  file.provenance(origin);
  write_samples(draw, field, file, output);
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
