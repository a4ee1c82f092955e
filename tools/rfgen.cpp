// rfgen: samples of a scene's random field on the field's mesh.
// Scene -> samples in an HDF5 file ("slidezone-fields 1").
//   rfgen pipelines/demo/scene.toml -n 24 -o fields.h5
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/progress.hpp"
#include "core/provenance.hpp"
#include "core/random.hpp"
#include "core/tool.hpp"
#include "field/random_field.hpp"
#include "io/file.hpp"
#include "io/hdf5_image.hpp"
#include "scene/scene.hpp"

namespace slidezone {
namespace {

struct Options {
  std::string scene;
  std::optional<std::uint64_t> count;  // absent: [study] realizations
  std::uint64_t first = 1;
  std::optional<std::uint64_t> seed;  // absent: [study] seed
  std::string output = "-";
};

constexpr std::uint64_t last_sample = std::numeric_limits<std::uint32_t>::max();

const char* const manual =
    R"(Samples of a scene's random field [field.cohesion], one value per cell of the field's mesh.

Samples are numbered from 1. Sample K depends on the scene's field, the seed and K alone: it is the same whenever, wherever and with
whatever other samples it is drawn. Values below the least residual cohesion of the scene's soils are raised to it and counted.
The result is an HDF5 file; data-schemas/fields.json lists what it holds.)";

/// The strength below which no soil of the scene can fall.
double least_residual(const Scene& scene) {
  double least = std::numeric_limits<double>::infinity();
  for (const Layer& layer : scene.layers) least = std::min(least, layer.material.residual_cohesion);
  return least;
}

FieldModel model_of(const FieldSpec& spec, double floor) {
  const FieldMesh mesh{spec.cell_x, spec.cell_y, spec.cells_x, spec.cells_y};
  return {mesh, spec.horizontal_scale, spec.vertical_scale, spec.mean, spec.cov, floor};
}

struct Samples {
  std::vector<std::int64_t> realization;
  std::vector<std::int64_t> floored;
  std::vector<double> values;  // [samples][cells_y][cells_x]
};

Samples draw(const FieldModel& model, RandomStream stream, std::uint64_t first, std::uint64_t count) {
  Progress progress("rfgen", is_quiet() ? Progress::Show::never : Progress::Show::on_terminal);
  Samples samples;
  samples.values.resize(count * model.mesh.size());
  for (std::uint64_t i = 0; i < count; ++i) {
    stream.sample = static_cast<std::uint32_t>(first + i);
    const std::size_t floored = fill_sample(std::span(samples.values).subspan(i * model.mesh.size(), model.mesh.size()), model, stream);
    samples.realization.push_back(static_cast<std::int64_t>(first + i));
    samples.floored.push_back(static_cast<std::int64_t>(floored));
    progress.update(static_cast<double>(i + 1) / static_cast<double>(count), "sample " + std::to_string(first + i));
  }
  return samples;
}

void run(const Options& options) {
  refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.soil = true, .field = true});
  const FieldSpec& spec = scene.fields.front();
  const FieldModel model = model_of(spec, least_residual(scene));
  const std::uint64_t seed = options.seed.value_or(scene.study.seed);
  const std::uint64_t count = options.count.value_or(scene.study.realizations);
  if (count > last_sample - options.first + 1)
    throw Error(ExitCode::usage, "samples are numbered up to " + std::to_string(last_sample) + "; lower --first or --count");
  const Samples samples = draw(model, {seed, purpose(spec.parameter), 0}, options.first, count);

  Hdf5Writer file;
  Provenance origin = provenance("slidezone-fields 1", "rfgen");
  origin.details = {{"scene", scene.checksum}, {"seed", std::to_string(seed)}};
  file.provenance(origin);
  file.dataset("realization", samples.realization);
  file.dataset(spec.parameter, samples.values, {count, static_cast<std::size_t>(spec.cells_y), static_cast<std::size_t>(spec.cells_x)});
  file.attribute(spec.parameter, "unit", std::string("Pa"));
  file.attribute(spec.parameter, "cell_x", spec.cell_x);
  file.attribute(spec.parameter, "cell_y", spec.cell_y);
  file.dataset("floored", samples.floored);
  write_output(options.output, file.image());
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
  app.add_option("-o,--output", options.output, "Fields (HDF5); - is stdout")->capture_default_str();
  return tool_main(app, "rfgen pipelines/demo/scene.toml -n 24 -o fields.h5", argc, argv, [&] { run(options); });
}
