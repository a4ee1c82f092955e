// rfmap: values of random field samples at a scene's material points.
// Scene, samples ("slidezone-fields 1") -> values at points in an HDF5 file ("slidezone-points 1").
//   rfmap pipelines/demo/scene.toml fields.h5 -o points.h5
#include <CLI/CLI.hpp>
#include <algorithm>
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

Cells longer than half a scale of fluctuation get a warning. A value below the residual cohesion of the point's own soil is raised to it; "floored" counts the points of each sample that stand
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

/// Takes the values of a field at the scene's points.
class Mapping {
 public:
  Mapping(const FieldSpec& spec, const MaterialPoints& points) {
    if (spec.interpolation == Interpolation::cell)
      cells_ = containing_cells(spec.model.mesh, points.x, points.y);
    else
      neighbours_ = neighbours(spec.model.mesh, points.x, points.y);
  }

  void map(std::span<double> values, std::span<const double> field) const {
    for (std::size_t p = 0; p < cells_.size(); ++p) values[p] = field[cells_[p]];
    for (std::size_t p = 0; p < neighbours_.size(); ++p) {
      const auto& [cells, weights] = neighbours_[p];
      values[p] = 0;
      for (std::size_t k = 0; k < cells.size(); ++k) values[p] += weights[k] * field[cells[k]];
    }
  }

 private:
  std::vector<std::size_t> cells_;  // one of the two is empty
  std::vector<Neighbours> neighbours_;
};

/// Raises values to the floors of their points; returns how many stand there.
std::int64_t raise_to_floors(std::span<double> values, std::span<const double> floors) {
  std::int64_t floored = 0;
  for (std::size_t p = 0; p < values.size(); ++p) {
    floored += values[p] <= floors[p] ? 1 : 0;
    values[p] = std::max(values[p], floors[p]);
  }
  return floored;
}

/// Cells longer than half a scale of fluctuation lose what varies between them.
void warn_of_coarse_cells(const FieldSpec& spec) {
  const Correlation& correlation = spec.model.correlation;
  const FieldMesh& mesh = spec.model.mesh;
  if (mesh.cell_x > correlation.horizontal_scale / 2 || mesh.cell_y > correlation.vertical_scale / 2)
    warn("the cells of the field, " + format_brief(mesh.cell_x) + " m x " + format_brief(mesh.cell_y) +
         " m, are longer than half its scales of fluctuation, " + format_brief(correlation.horizontal_scale) + " m and " +
         format_brief(correlation.vertical_scale) + " m; a finer mesh would resolve them");
}

void run(const Options& options) {
  refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.grid = true, .soil = true, .field = true});
  const FieldSpec& spec = scene.fields.front();
  const std::string image = read_input(options.fields);
  const Hdf5Reader fields(image, input_name(options.fields), "slidezone-fields 1");
  const std::vector<std::int64_t> realizations = fields.integers("realization");
  check_mesh(mesh_of(fields, spec.parameter, realizations.size()), spec.model.mesh, fields, scene);
  warn_of_coarse_cells(spec);

  const MaterialPoints points = material_points(scene);
  const Mapping mapping(spec, points);
  const std::vector<double> floors = floors_of(points, scene);
  std::vector<std::int64_t> floored(realizations.size());

  Hdf5Writer file;
  Provenance origin = provenance("slidezone-points 1", "rfmap");
  origin.details = {{"scene", scene.checksum}, {"fields", checksum(image)}, {"seed", fields.text_attribute("", "seed")}};
  file.provenance(origin);
  file.dataset("realization", realizations);
  file.dataset("x", points.x, {points.x.size()});
  file.dataset("y", points.y, {points.y.size()});
  file.dataset_later(spec.parameter, {realizations.size(), points.x.size()}, [&](std::size_t sample, std::span<double> values) {
    mapping.map(values, fields.reals(spec.parameter, sample));
    floored[sample] = raise_to_floors(values, floors);
  });
  file.attribute(spec.parameter, "unit", fields.text_attribute(spec.parameter, "unit"));
  file.dataset_later("floored", floored.size(),
                     [&](std::size_t, std::span<std::int64_t> values) { std::ranges::copy(floored, values.begin()); });
  OutputFile output(options.output);
  file.write([&](std::string_view bytes) { output.write(bytes); });
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
