// rfmap: values of random field samples at a scene's material points.
// Scene, samples ("slidezone-fields 1") -> values at points in an HDF5 file ("slidezone-points 1").
//   rfmap pipelines/demo/scene.toml fields.h5 -o points.h5
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"
#include "core/tool.hpp"
#include "field/mesh.hpp"
#include "io/file.hpp"
#include "io/hdf5_image.hpp"
#include "scene/scene.hpp"

namespace slidezone {
namespace {

struct Options {
  std::string scene;
  std::string fields;
  std::string output = "-";
};

const char* const manual =
    R"(Values of random field samples at the scene's material points: the value of the field's cell that contains each point.

A value below the residual cohesion of the point's own soil is raised to it; "floored" counts the points of each sample that stand
at that floor, also those whose cell rfgen had raised. The fields must be of the mesh that the scene describes.
The result is an HDF5 file; data-schemas/points.json lists what it holds.)";

std::string description(const FieldMesh& mesh) {
  return std::to_string(mesh.cells_x) + " x " + std::to_string(mesh.cells_y) + " cells of " + format_brief(mesh.cell_x, 9) + " m x " +
         format_brief(mesh.cell_y, 9) + " m";
}

/// The mesh of the field `parameter` of a file of `samples` samples.
FieldMesh mesh_of(const Hdf5Reader& fields, const std::string& parameter, std::size_t samples) {
  const std::vector<std::size_t> shape = fields.shape(parameter);
  if (shape.size() != 3 || shape[0] != samples)
    throw Error(ExitCode::data,
                fields.name() + ": '" + parameter + "' wants the shape [" + std::to_string(samples) + ", cells_y, cells_x]");
  return {fields.real_attribute(parameter, "cell_x"), fields.real_attribute(parameter, "cell_y"), static_cast<int>(shape[2]),
          static_cast<int>(shape[1])};
}

/// Fields of another mesh would put the values in wrong places.
void check_mesh(const FieldMesh& found, const FieldMesh& expected, const Hdf5Reader& fields, const Scene& scene) {
  const bool is_same = found.cell_x == expected.cell_x && found.cell_y == expected.cell_y && found.cells_x == expected.cells_x &&
                       found.cells_y == expected.cells_y;
  if (!is_same)
    throw Error(ExitCode::data, fields.name() + ": found a field of " + description(found) + ", but " + scene.name + " describes one of " +
                                    description(expected) + "; draw the fields from this scene");
}

/// Residual cohesion at each point.
std::vector<double> floors_of(const MaterialPoints& points, const Scene& scene) {
  std::vector<double> floors;
  for (const int layer : points.layer) floors.push_back(scene.layers[static_cast<std::size_t>(layer)].material.residual_cohesion);
  return floors;
}

/// Fills `values` with the field's values at the points; returns how many stand at their floor.
std::int64_t map(std::span<double> values, std::span<const double> field, std::span<const std::size_t> cells,
                 std::span<const double> floors) {
  std::int64_t floored = 0;
  for (std::size_t p = 0; p < cells.size(); ++p) {
    const double value = field[cells[p]];
    floored += value <= floors[p] ? 1 : 0;
    values[p] = std::max(value, floors[p]);
  }
  return floored;
}

void run(const Options& options) {
  refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.grid = true, .soil = true, .field = true});
  const FieldSpec& spec = scene.fields.front();
  const std::string image = read_input(options.fields);
  const Hdf5Reader fields(image, input_name(options.fields), "slidezone-fields 1");
  const std::vector<std::int64_t> realizations = fields.integers("realization");
  const FieldMesh mesh = mesh_of(fields, spec.parameter, realizations.size());
  check_mesh(mesh, spec.model.mesh, fields, scene);

  const MaterialPoints points = material_points(scene);
  const std::vector<std::size_t> cells = containing_cells(mesh, points.x, points.y);
  const std::vector<double> floors = floors_of(points, scene);
  std::vector<double> values(realizations.size() * cells.size());
  std::vector<std::int64_t> floored;
  for (std::size_t k = 0; k < realizations.size(); ++k)
    floored.push_back(map(std::span(values).subspan(k * cells.size(), cells.size()), fields.reals(spec.parameter, k), cells, floors));

  Hdf5Writer file;
  Provenance origin = provenance("slidezone-points 1", "rfmap");
  origin.details = {{"scene", scene.checksum}, {"fields", checksum(image)}, {"seed", fields.text_attribute("", "seed")}};
  file.provenance(origin);
  file.dataset("realization", realizations);
  file.dataset("x", points.x, {points.x.size()});
  file.dataset("y", points.y, {points.y.size()});
  file.dataset(spec.parameter, values, {realizations.size(), cells.size()});
  file.attribute(spec.parameter, "unit", fields.text_attribute(spec.parameter, "unit"));
  file.dataset("floored", floored);
  write_output(options.output, file.image());
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
