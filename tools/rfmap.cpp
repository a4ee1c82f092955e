// rfmap: values of random field samples at a scene's material points.
// Scene, samples ("slidezone-fields 1") -> values at points in an HDF5 file ("slidezone-points 1").
//   rfmap pipelines/demo/scene.toml fields.h5 -o points.h5
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
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
#include "scene/varied_soil.hpp"

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

/// Takes the values of a field at the points whose soils have it.
class Mapping {
 public:
  Mapping(const FieldSpec& spec, const MaterialPoints& points) {
    std::vector<double> x, y;
    for (std::size_t p = 0; p < points.x.size(); ++p) {
      if (std::ranges::find(spec.soils, static_cast<std::size_t>(points.layer[p])) == spec.soils.end()) continue;
      points_.push_back(p);
      x.push_back(points.x[p]);
      y.push_back(points.y[p]);
    }
    if (spec.interpolation == Interpolation::cell)
      cells_ = containing_cells(spec.model.mesh, x, y);
    else
      neighbours_ = neighbours(spec.model.mesh, x, y);
  }

  void map(std::vector<ParameterValues>& values, Parameter parameter, std::span<const double> field) const {
    const auto which = static_cast<std::size_t>(parameter);
    for (std::size_t i = 0; i < cells_.size(); ++i) values[points_[i]][which] = field[cells_[i]];
    for (std::size_t i = 0; i < neighbours_.size(); ++i) {
      const auto& [cells, weights] = neighbours_[i];
      double value = 0;
      for (std::size_t k = 0; k < cells.size(); ++k) value += weights[k] * field[cells[k]];
      values[points_[i]][which] = value;
    }
  }

 private:
  std::vector<std::size_t> points_;
  std::vector<std::size_t> cells_;  // one of the two is empty
  std::vector<Neighbours> neighbours_;
};

/// The values of all parameters of one sample after another at the points.
class Mapper {
 public:
  Mapper(const Scene& scene, const MaterialPoints& points, const Hdf5Reader& fields) : scene_(scene), points_(points), fields_(fields) {
    for (const FieldSpec& spec : scene.fields) mappings_.emplace_back(spec, points);
  }

  /// Takes up a sample; returns how many values stand at a limit.
  std::size_t take(std::size_t sample) {
    values_.assign(points_.x.size(), {});
    for (std::size_t i = 0; i < mappings_.size(); ++i)
      mappings_[i].map(values_, scene_.fields[i].parameter, fields_.reals(scene_.fields[i].name, sample));
    std::size_t at_limits = 0;
    for (std::size_t p = 0; p < values_.size(); ++p) at_limits += hold_within_limits(values_[p], layer(p));
    return at_limits;
  }

  /// The values of a parameter; the soil's own where it has no field, which may follow those of another parameter.
  void fill(std::span<double> values, Parameter parameter) const {
    for (std::size_t p = 0; p < values.size(); ++p) {
      const std::optional<double>& value = values_[p][static_cast<std::size_t>(parameter)];
      values[p] = value ? *value : value_of(varied_soil(layer(p), values_[p]), parameter);
    }
  }

 private:
  const Layer& layer(std::size_t point) const { return scene_.layers[static_cast<std::size_t>(points_.layer[point])]; }

  const Scene& scene_;
  const MaterialPoints& points_;
  const Hdf5Reader& fields_;
  std::vector<Mapping> mappings_;
  std::vector<ParameterValues> values_;
};

/// Which parameters have a field, in the order of Parameter.
std::vector<Parameter> varying(const Scene& scene) {
  std::set<Parameter> parameters;
  for (const FieldSpec& spec : scene.fields) parameters.insert(spec.parameter);
  return {parameters.begin(), parameters.end()};
}

/// Cells longer than half a scale of fluctuation lose what varies between them.
void warn_of_coarse_cells(const FieldSpec& spec) {
  const Correlation& correlation = spec.model.correlation;
  const FieldMesh& mesh = spec.model.mesh;
  if (mesh.cell_x > correlation.horizontal_scale / 2 || mesh.cell_y > correlation.vertical_scale / 2)
    warn("the cells of the field " + spec.name + ", " + format_brief(mesh.cell_x) + " m x " + format_brief(mesh.cell_y) +
         " m, are longer than half its scales of fluctuation, " + format_brief(correlation.horizontal_scale) + " m and " +
         format_brief(correlation.vertical_scale) + " m; a finer mesh would resolve them");
}

void write_points(const Scene& scene, const Hdf5Reader& fields, const MaterialPoints& points, Hdf5Writer& file, OutputFile& output) {
  const std::vector<std::int64_t> realizations = fields.integers("realization");
  std::vector<std::int64_t> floored(realizations.size());
  Mapper mapper(scene, points, fields);
  std::vector<Hdf5Writer::LaterDataset> datasets;
  for (const Parameter parameter : varying(scene)) {
    const bool is_first = datasets.empty();
    datasets.push_back({kind_of(parameter).name,
                        {realizations.size(), points.x.size()},
                        [&, is_first, parameter](std::size_t sample, std::span<double> values) {
                          if (is_first) floored[sample] = static_cast<std::int64_t>(mapper.take(sample));
                          mapper.fill(values, parameter);
                        }});
  }
  file.dataset("realization", realizations);
  file.dataset("block", fields.integers("block"));
  file.dataset("x", points.x, {points.x.size()});
  file.dataset("y", points.y, {points.y.size()});
  file.datasets_later(datasets);
  for (const Parameter parameter : varying(scene)) file.attribute(kind_of(parameter).name, "unit", std::string(kind_of(parameter).unit));
  file.dataset_later("floored", floored.size(),
                     [&](std::size_t, std::span<std::int64_t> values) { std::ranges::copy(floored, values.begin()); });
  file.write([&](std::string_view bytes) { output.write(bytes); });
}

void run(const Options& options) {
  refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.grid = true, .soil = true, .field = true});
  const std::string image = read_input(options.fields);
  const Hdf5Reader fields(image, input_name(options.fields), "slidezone-fields 1");
  const std::size_t samples = fields.integers("realization").size();
  for (const FieldSpec& spec : scene.fields) {
    check_mesh(mesh_of(fields, spec.name, samples), spec.model.mesh, fields, scene);
    warn_of_coarse_cells(spec);
  }
  const MaterialPoints points = material_points(scene);
  Hdf5Writer file;
  Provenance origin = provenance("slidezone-points 1", "rfmap");
  origin.details = {{"scene", scene.checksum},
                    {"fields", checksum(image)},
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
