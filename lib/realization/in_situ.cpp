#include "realization/in_situ.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/hdf5_image.hpp"
#include "realization/realization.hpp"

namespace slidezone {

/// The scene with the lowest strength that its fields can have; nothing where they vary more than strength.
static std::optional<Model> weakest_model(const Scene& scene, const MaterialPoints& points) {
  FieldSample weakest;
  weakest.values.resize(points.x.size());
  for (const FieldSpec& field : scene.fields) {
    if (field.parameter != Parameter::cohesion) return {};
    for (std::size_t p = 0; p < points.x.size(); ++p) {
      const auto soil = static_cast<std::size_t>(points.layer[p]);
      if (std::ranges::find(field.soils, soil) == field.soils.end()) continue;
      weakest.values[p][static_cast<std::size_t>(Parameter::cohesion)] = least_cohesion(scene.layers[soil]);
    }
  }
  return model_of(scene, points, weakest);
}

std::optional<ElasticStage> in_situ_stage(const Scene& scene, const MaterialPoints& points) {
  std::optional<Model> model = weakest_model(scene, points);
  return model ? elastic_stage(std::move(*model)) : std::nullopt;
}

void check_shares_stage(const Model& model, const Scene& scene, const MaterialPoints& points, const std::string& name) {
  const std::optional<Model> weakest = weakest_model(scene, points);
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    const double cohesion = model.points.peak_cohesion[p];
    const double least = weakest->points.peak_cohesion[p];
    Material soil = soil_of(model, model.points, p);
    const Material& expected = soil_of(*weakest, weakest->points, p);
    soil.peak_cohesion = expected.peak_cohesion;
    soil.residual_cohesion = expected.residual_cohesion;
    if (cohesion >= least && soil == expected) continue;
    throw Error(ExitCode::data,
                name + ": point " + std::to_string(p) + " has " +
                    (cohesion < least ? "a cohesion of " + format_brief(cohesion) + " Pa, below the " + format_brief(least) + " Pa"
                                      : "other parameters than the soil") +
                    " of the in-situ stage; was it made from another scene?");
  }
}

// ---- file -----------------------------------------------------------------------------------------------------------------------

namespace {

struct PointArray {
  const char* name;
  PointNumbers<double> Points::*values;
  std::size_t components;
};
constexpr std::array<PointArray, 9> point_arrays = {{{"points/x", &Points::x, 1},
                                                     {"points/y", &Points::y, 1},
                                                     {"points/velocity", &Points::velocity, 2},
                                                     {"points/movement", &Points::movement, 2},
                                                     {"points/stress_xx", &Points::xx, 1},
                                                     {"points/stress_yy", &Points::yy, 1},
                                                     {"points/stress_zz", &Points::zz, 1},
                                                     {"points/stress_xy", &Points::xy, 1},
                                                     {"points/volume", &Points::volume, 1}}};

struct Work {
  const char* name;
  double EnergyAudit::*value;
};
constexpr std::array<Work, 6> works = {{{"gravity_work", &EnergyAudit::gravity_work},
                                        {"internal_work", &EnergyAudit::internal_work},
                                        {"friction_work", &EnergyAudit::friction_work},
                                        {"friction_excess", &EnergyAudit::friction_excess},
                                        {"damping_work", &EnergyAudit::damping_work},
                                        {"least_work", &EnergyAudit::least_work}}};

std::vector<std::size_t> shape_of(std::size_t count, std::size_t components) {
  return components == 1 ? std::vector{count} : std::vector{count, components};
}

}  // namespace

/// The numbers of columns one after the other, and back.
static std::vector<double> numbers_of(const std::vector<ColumnContact>& columns) {
  std::vector<double> numbers;
  for (const ColumnContact& column : columns) numbers.insert(numbers.end(), {column.along, column.upward, column.work});
  return numbers;
}

static std::vector<ColumnContact> columns_of(const std::vector<double>& numbers) {
  std::vector<ColumnContact> columns;
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3) columns.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
  return columns;
}

std::string stage_file(const std::optional<ElasticStage>& stage, const Provenance& provenance) {
  Hdf5Writer file;
  file.provenance(provenance);
  if (!stage) return file.image();
  file.dataset("kinetic_energy", stage->kinetic, {stage->kinetic.size()});
  for (const Work& work : works) file.attribute("", work.name, stage->energy.*work.value);
  file.group("points");
  const Points& points = stage->points;
  file.dataset("points/label", std::vector<std::int64_t>(points.label.begin(), points.label.end()));
  for (const PointArray& array : point_arrays) file.dataset(array.name, points.*array.values, shape_of(points.count(), array.components));
  file.group("nodes");
  const NodeBox& box = stage->box;
  file.dataset("nodes/box", std::vector<std::int64_t>{box.first_column, box.last_column, box.first_row, box.last_row});
  file.dataset("nodes/velocity", stage->new_velocity, {stage->new_velocity.size() / 2, 2});
  file.dataset("nodes/base_contact", numbers_of(stage->contact), {stage->contact.size(), 3});
  return file.image();
}

/// Of files that were not changed by hand all this holds.
static void check_places(const ElasticStage& stage, const std::string& name, const NodeStorage& storage) {
  const auto count = static_cast<int>(stage.points.label.size());
  const bool has_points = std::ranges::all_of(stage.points.label, [&](int label) { return label >= 0 && label < count; });
  const NodeBox& box = stage.box;
  const bool has_nodes = box.first_column >= 0 && box.first_column < box.last_column && box.last_column <= storage.columns &&
                         box.first_row >= 0 && box.first_row < box.last_row && box.last_row <= storage.rows;
  if (!has_points || !has_nodes) throw Error(ExitCode::data, name + ": names points or nodes that the scene does not have");
}

static void check_origin(const Hdf5Reader& file, const Scene& scene) {
  const std::string maker = provenance("", "mpmrun").tool;
  const auto check = [&](const char* attribute, const std::string& expected, const std::string& hint) {
    if (const std::string found = file.text_attribute("", attribute); found != expected)
      throw Error(ExitCode::data, file.name() + ": found a stage of " + attribute + " " + found + ", expected " + expected + "; " + hint);
  };
  check("tool", maker, "make it anew with --make-in-situ");
  check("scene", scene.checksum, "was it made from another scene?");
}

std::optional<ElasticStage> stage_in(std::string_view image, const std::string& name, const Scene& scene, const MaterialPoints& points) {
  const Hdf5Reader file(image, name, "slidezone-stage 1");
  check_origin(file, scene);
  if (!file.has("points")) return {};
  const auto check_size = [&](const char* dataset, std::size_t found, std::size_t expected) {
    if (found != expected)
      throw Error(ExitCode::data,
                  name + ": '" + dataset + "' has " + std::to_string(found) + " numbers, expected " + std::to_string(expected));
  };
  ElasticStage stage;
  stage.kinetic = file.reals("kinetic_energy");
  for (const Work& work : works) stage.energy.*work.value = file.real_attribute("", work.name);
  for (const PointArray& array : point_arrays) {
    const std::vector<double> values = file.reals(array.name);
    check_size(array.name, values.size(), array.components * points.x.size());
    (stage.points.*array.values).assign(values.begin(), values.end());
  }
  const std::vector<std::int64_t> label = file.integers("points/label");
  check_size("points/label", label.size(), points.x.size());
  stage.points.label.assign(label.begin(), label.end());
  const std::vector<std::int64_t> box = file.integers("nodes/box");
  check_size("nodes/box", box.size(), 4);
  stage.box = {static_cast<int>(box[0]), static_cast<int>(box[1]), static_cast<int>(box[2]), static_cast<int>(box[3])};
  check_places(stage, name, NodeStorage(scene.discretization.grid));
  stage.new_velocity = file.reals("nodes/velocity");
  check_size("nodes/velocity", stage.new_velocity.size(),
             2 * static_cast<std::size_t>(stage.box.last_column - stage.box.first_column) *
                 static_cast<std::size_t>(stage.box.last_row - stage.box.first_row));
  const std::vector<double> contact = file.reals("nodes/base_contact");
  check_size("nodes/base_contact", contact.size(),
             scene.boundaries.has_friction() ? 3 * static_cast<std::size_t>(NodeStorage(scene.discretization.grid).columns) : 0);
  stage.contact = columns_of(contact);
  return stage;
}

}  // namespace slidezone
