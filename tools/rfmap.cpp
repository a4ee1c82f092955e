// rfmap: values of random field samples at a scene's material points.
// Scene, samples ("slidezone-fields 1") -> values at points in an HDF5 file ("slidezone-points 1").
//   rfmap pipelines/demo/scene.toml fields.h5 -o points.h5
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"
#include "core/tool.hpp"
#include "field/mesh.hpp"
#include "io/file.hpp"
#include "io/hdf5_image.hpp"
#include "sampling/mapper.hpp"
#include "scene/scene.hpp"

namespace slidezone {
namespace {

struct Options {
  std::string scene;
  std::string fields;
  std::string output = "-";
};

const char* const manual =
    R"(Values of random field samples at the scene's material points: the value of the field's cell that contains each point,
or with interpolation = "linear" in the scene a value linear between the centres of cells.

All fields of the scene are mapped at once, one dataset for each parameter; a point whose soil has no field of a parameter has the soil's
own value. Cells longer than half a scale of fluctuation get a warning. A cohesion or friction angle below the residual one of the
point's own soil is raised to it, a residual cohesion above the peak is lowered to it, a friction angle above 89 degrees to that;
"floored" counts the values of each sample that stand at such a limit, also those that rfgen had moved. The fields must be of the mesh
that the scene describes.
The result is an HDF5 file; data-schemas/points.json lists what it holds.)";

std::string description(const FieldMesh& mesh) {
  return std::to_string(mesh.cells_x) + " x " + std::to_string(mesh.cells_y) + " cells of " + format_brief(mesh.cell_x, 9) + " m x " +
         format_brief(mesh.cell_y, 9) + " m";
}

/// The mesh of the field `name` of a file of `samples` samples.
FieldMesh mesh_of(const Hdf5Reader& fields, const std::string& name, std::size_t samples) {
  const std::vector<std::size_t> shape = fields.shape(name);
  if (shape.size() != 3 || shape[0] != samples)
    throw Error(ExitCode::data, fields.name() + ": '" + name + "' wants the shape [" + std::to_string(samples) + ", cells_y, cells_x]");
  return {fields.real_attribute(name, "cell_x"), fields.real_attribute(name, "cell_y"), static_cast<int>(shape[2]),
          static_cast<int>(shape[1])};
}

/// Fields of another mesh would put the values in wrong places.
void check_mesh(const FieldMesh& found, const FieldMesh& expected, const Hdf5Reader& fields, const Scene& scene) {
  if (found != expected)
    throw Error(ExitCode::data, fields.name() + ": found a field of " + description(found) + ", but " + scene.name + " describes one of " +
                                    description(expected) + "; draw the fields from this scene");
}

/// Cells longer than half a scale of fluctuation lose what varies between them. Scales along x and y are those of the ellipse of the
/// bedding; without bedding angle, the scales of the scene.
void warn_of_coarse_cells(const FieldSpec& spec) {
  const Correlation& correlation = spec.model.correlation;
  const FieldMesh& mesh = spec.model.mesh;
  constexpr double room = 1e-9;  // for rounding
  const double cosine = std::cos(correlation.bedding_angle), sine = std::sin(correlation.bedding_angle);
  const double scale_x = 1 / std::hypot(cosine / correlation.horizontal_scale, sine / correlation.vertical_scale);
  const double scale_y = 1 / std::hypot(sine / correlation.horizontal_scale, cosine / correlation.vertical_scale);
  if (mesh.cell_x > scale_x / 2 * (1 + room) || mesh.cell_y > scale_y / 2 * (1 + room))
    warn("the cells of the field " + spec.name + ", " + format_brief(mesh.cell_x) + " m x " + format_brief(mesh.cell_y) +
         " m, are longer than half its scales of fluctuation, " + format_brief(scale_x) + " m and " + format_brief(scale_y) +
         " m along x and y; a finer mesh would resolve them");
}

void write_points(const Scene& scene, const Hdf5Reader& fields, const MaterialPoints& points, Hdf5Writer& file, OutputFile& output) {
  const std::vector<std::int64_t> realizations = fields.integers("realization");
  std::vector<std::int64_t> floored(realizations.size());
  Mapper mapper(scene, points);
  std::vector<Hdf5Writer::LaterDataset> datasets;
  for (const Parameter parameter : varying_parameters(scene)) {
    const bool is_first = datasets.empty();
    datasets.push_back({kind_of(parameter).name,
                        {realizations.size(), points.x.size()},
                        [&, is_first, parameter](std::size_t sample, std::span<double> values) {
                          if (is_first)
                            floored[sample] = static_cast<std::int64_t>(
                                mapper.take([&](std::size_t i) { return fields.reals(scene.fields[i].name, sample); }));
                          mapper.fill(values, parameter);
                        }});
  }
  file.dataset("realization", realizations);
  file.dataset("block", fields.integers("block"));
  file.dataset("x", points.x, {points.x.size()});
  file.dataset("y", points.y, {points.y.size()});
  file.datasets_later(datasets);
  for (const Parameter parameter : varying_parameters(scene))
    file.attribute(kind_of(parameter).name, "unit", std::string(kind_of(parameter).unit));
  file.dataset_later("floored", floored.size(),
                     [&](std::size_t, std::span<std::int64_t> values) { std::ranges::copy(floored, values.begin()); });
  file.write([&](std::string_view bytes) { output.write(bytes); });
}

void run(const Options& options) {
  refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.grid = true, .soil = true, .field = true});
  const InputFile image(options.fields);
  const Hdf5Reader fields(image.bytes(), input_name(options.fields), "slidezone-fields 1");
  const std::size_t samples = fields.integers("realization").size();
  if (fields.text_attribute("", "scene") != scene.checksum)
    note(fields.name() + " was made from another scene than " + scene.name + ", or before it was changed");
  for (const FieldSpec& spec : scene.fields) {
    check_mesh(mesh_of(fields, spec.name, samples), spec.model.mesh, fields, scene);
    warn_of_coarse_cells(spec);
  }
  const MaterialPoints points = material_points(scene);
  Hdf5Writer file;
  Provenance origin = provenance("slidezone-points 1", "rfmap");
  origin.details = {{"scene", scene.checksum},
                    {"fields", checksum(image.bytes())},
                    {"fields_scene", fields.text_attribute("", "scene")},
                    {"seed", fields.text_attribute("", "seed")},
                    {"design", fields.text_attribute("", "design")}};
  file.provenance(origin);
  OutputFile output(options.output);
  write_points(scene, fields, points, file, output);
  output.finish();
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  Options options;
  CLI::App app{manual, "rfmap"};
  app.add_option("scene", options.scene, "Scene (TOML); - is stdin")->required();
  app.add_option("fields", options.fields, "Field samples of this scene, from rfgen; - is stdin")->required();
  app.add_option("-o,--output", options.output, "Values at the points (HDF5); - is stdout")->capture_default_str();
  return tool_main(app, "rfmap pipelines/demo/scene.toml fields.h5 -o points.h5", argc, argv, [&] { run(options); });
}
