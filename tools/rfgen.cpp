// rfgen: samples of a scene's random fields on the fields' meshes.
// Scene, and the measurements that it names ("slidezone-measurements 1") -> samples in an HDF5 file ("slidezone-fields 1").
//   rfgen pipelines/demo/scene.toml -n 24 -o fields.h5
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
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
#include "core/tool.hpp"
#include "io/file.hpp"
#include "io/hdf5_image.hpp"
#include "sampling/field_check.hpp"
#include "sampling/sampler.hpp"
#include "scene/scene.hpp"

namespace slidezone {
namespace {

struct Options {
  std::string scene;
  std::optional<std::uint64_t> count;  // absent: [study] realizations
  std::uint64_t first = 1;
  std::optional<std::uint64_t> seed;  // absent: [study] seed
  bool explain = false;
  bool check = false;
  std::string output = "-";
};

constexpr std::uint64_t last_sample = std::numeric_limits<std::uint32_t>::max();

const char* const manual =
    R"(Samples of a scene's random fields, one value per cell of each field's mesh.

A scene may have a field of cohesion, residual_cohesion, friction_angle, youngs_modulus and unit_weight or density: [field.cohesion] in
all soils, [soil.field.cohesion] in one alone, correlated by [field.cross_correlation], of a mean that changes with depth.
Samples are numbered from 1. Sample K depends on the scene's fields, the seed and K alone: it is the same whenever, wherever and with
whatever other samples it is drawn, also in the antithetic pairs or Latin hypercubes that [study] design may ask for.
The scene chooses autocorrelation, marginal distribution and method; --explain says what that comes to, --check holds samples against
it: each drawn by itself, without measurements or design, as its output says; pipelines/plots/check.gp draws its table. Where the scene
names a table of measurements (data-schemas/measurements.json), all other samples honour those in soils that have the field. Cohesions
and friction angles below the least residual ones of the scene's soils are raised to them, friction angles above 89 degrees lowered to
that, and counted.
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

/// What of the scene --check leaves out.
std::string drawn(const Scene& scene) {
  const bool has_measurements = std::ranges::any_of(scene.fields, [](const FieldSpec& spec) { return !spec.measurements.empty(); });
  const std::string design = scene.study.design.design == Design::plain ? "" : "the design \"" + to_string(scene.study.design.design) + '"';
  if (!has_measurements && design.empty()) return "as the scene says";
  return "without " + (has_measurements ? "its measurements" + (design.empty() ? design : " and " + design) : design);
}

/// What --check prints: samples against theory, and a verdict.
std::string check(const Scene& scene, const Draw& draw) {
  constexpr std::uint64_t least = 20;
  if (draw.count < least)
    throw Error(ExitCode::usage, "--check wants at least " + std::to_string(least) + " samples, found " + std::to_string(draw.count));
  Progress progress("rfgen", is_quiet() ? Progress::Show::never : Progress::Show::on_terminal);
  RandomFields fields = plain_fields_of(scene, draw.seed);
  const Table table = field_check(scene, fields, static_cast<std::uint32_t>(draw.first), draw.count, [&](std::size_t done) {
    progress.update(static_cast<double>(done) / static_cast<double>(draw.count), "sample " + std::to_string(draw.first + done - 1));
  });
  Provenance origin = provenance("slidezone-field-check 1", "rfgen");
  origin.details = {{"scene", scene.checksum},
                    {"seed", std::to_string(draw.seed)},
                    {"first", std::to_string(draw.first)},
                    {"drawn", drawn(scene)},
                    {"verdict", verdict_of(table)}};
  return to_tsv(table, origin);
}

void run(const Options& options) {
  if (!options.explain && !options.check) refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.soil = true, .field = true});
  const Draw draw = draw_of(options, scene);
  if (options.check) return write_output(options.output, check(scene, draw));
  Sampler sampler = sampler_of(scene, draw.seed);
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
  app.add_flag("--check", options.check,
               "Print how the samples agree with their model (TSV): mean, COV, correlations, each with its interval")
      ->excludes("--explain");
  app.add_option("-o,--output", options.output, "Fields (HDF5); - is stdout")->capture_default_str();
  return tool_main(app, "rfgen pipelines/demo/scene.toml -n 24 -o fields.h5", argc, argv, [&] { run(options); });
}
