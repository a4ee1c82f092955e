#include "realization/realization.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/hdf5_image.hpp"
#include "io/table.hpp"
#include "io/vtkhdf.hpp"
#include "reach/reach.hpp"

namespace slidezone {

// ---- from a scene to a model ------------------------------------------------------------------------------------------------

static void check_points(const std::vector<double>& found, const std::vector<double>& expected, const std::string& name, const char* axis) {
  if (found.size() != expected.size())
    throw Error(ExitCode::data, name + ": found " + std::to_string(found.size()) + " material points, the scene has " +
                                    std::to_string(expected.size()) + "; was it made from another scene?");
  for (std::size_t p = 0; p < found.size(); ++p) {
    if (std::abs(found[p] - expected[p]) <= 1e-9 * (1 + std::abs(expected[p]))) continue;
    throw Error(ExitCode::data, name + ": point " + std::to_string(p) + " has " + axis + " = " + format_real(found[p]) +
                                    " m, the scene has " + format_real(expected[p]) + " m; was it made from another scene?");
  }
}

FieldSample field_sample(std::string_view image, const std::string& name, const MaterialPoints& points, std::uint64_t realization) {
  const Hdf5Reader file(image, name, "slidezone-points 1");
  check_points(file.reals("x"), points.x, name, "x");
  check_points(file.reals("y"), points.y, name, "y");
  const std::vector<std::int64_t> numbers = file.integers("realization");
  const auto found = std::find(numbers.begin(), numbers.end(), static_cast<std::int64_t>(realization));
  if (found == numbers.end())
    throw Error(ExitCode::data,
                name + ": holds no sample " + std::to_string(realization) +
                    (numbers.empty() ? "" : ", only " + std::to_string(numbers.front()) + " to " + std::to_string(numbers.back())));
  const auto index = static_cast<std::size_t>(found - numbers.begin());
  FieldSample sample;
  sample.scene = file.text_attribute("", "scene");
  sample.fields_scene = file.text_attribute("", "fields_scene");
  sample.realization = realization;
  sample.values.resize(points.x.size());
  const auto is_there = [&](const ParameterKind& kind) { return file.has(kind.name); };
  if (std::none_of(parameter_kinds.begin(), parameter_kinds.end(), is_there))
    throw Error(ExitCode::data, name + ": holds no soil parameter that mpmrun knows");
  for (std::size_t parameter = 0; parameter < parameter_kinds.size(); ++parameter) {
    if (!file.has(parameter_kinds[parameter].name)) continue;
    const std::vector<double> values = file.reals(parameter_kinds[parameter].name, index);
    if (values.size() != points.x.size())
      throw Error(ExitCode::data, name + ": '" + parameter_kinds[parameter].name + "' has " + std::to_string(values.size()) +
                                      " values a sample, the scene has " + std::to_string(points.x.size()) + " points");
    for (std::size_t p = 0; p < values.size(); ++p) sample.values[p][parameter] = values[p];
  }
  sample.floored = static_cast<std::uint64_t>(file.integers("floored").at(index));
  sample.block = static_cast<std::uint64_t>(file.integers("block").at(index));
  const std::string design = file.text_attribute("", "design");
  if (!design_named(design)) throw Error(ExitCode::data, name + ": found the design '" + design + "', expected " + list_of(design_names()));
  sample.design = *design_named(design);
  return sample;
}

/// Geostatic stress, column by column from the top; points come column by column from the base up.
static void start_from_k0(Model& model) {
  const Points& points = model.points;
  const double g = -model.gravity.acceleration.y;
  double above = 0;  // stress by the points above, Pa
  for (std::size_t p = points.count(); p-- > 0;) {
    const bool is_top = p + 1 == points.count() || points.x[p + 1] != points.x[p];
    if (is_top) above = 0;
    const Material& soil = soil_of(model, points, p);
    const double own = soil.density * g * model.point_spacing_y;
    const double k0 = model.gravity.k0.value_or(soil.poisson_ratio / (1 - soil.poisson_ratio));
    model.points.yy[p] = -(above + 0.5 * own);
    model.points.xx[p] = model.points.zz[p] = k0 * points.yy[p];
    above += own;
  }
}

static Material soil_at_point(const Scene& scene, const MaterialPoints& points, const std::optional<FieldSample>& sample, std::size_t p) {
  const Layer& layer = scene.layers[static_cast<std::size_t>(points.layer[p])];
  if (!sample) return layer.material;
  ParameterValues values = sample->values[p];
  hold_within_limits(values, layer);
  return varied_soil(layer, values);
}

/// Whether a point needs a soil of its own: peak cohesion alone is an array of the points. Where no soil softens, a residual strength has
/// no part in the run.
static bool differs_beyond_peak_cohesion(const Material& soil, Material expected) {
  expected.peak_cohesion = soil.peak_cohesion;
  if (expected.softening_shape == 0) expected.residual_cohesion = soil.residual_cohesion;
  return soil != expected;
}

/// The limit of the step depends on each point's soil, and so is known only now.
static void check_step(const Model& model, const Scene& scene) {
  try {
    time_step(model);
  } catch (const Error& error) {
    throw Error(error.code(), scene.name + ": [time]: " + error.what());
  }
}

Model model_of(const Scene& scene, const MaterialPoints& points, const std::optional<FieldSample>& sample) {
  Model model;
  model.grid = scene.discretization.grid;
  model.point_spacing_x = points.spacing_x;
  model.point_spacing_y = points.spacing_y;
  for (const Layer& layer : scene.layers) model.soils.push_back(layer.material);
  model.boundaries = scene.boundaries;
  model.gravity = scene.gravity;
  model.time = scene.time;
  model.method = scene.method;
  model.nonlocal_softening = scene.nonlocal_softening;
  model.points = points_at_rest(points.x.size());
  model.points.x.assign(points.x.begin(), points.x.end());
  model.points.y.assign(points.y.begin(), points.y.end());
  model.points.soil.assign(points.layer.begin(), points.layer.end());
  const double volume = points.spacing_x * points.spacing_y;
  bool has_layers_alone = true;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    const Material soil = soil_at_point(scene, points, sample, p);
    has_layers_alone &= !differs_beyond_peak_cohesion(soil, model.soils[static_cast<std::size_t>(points.layer[p])]);
    model.points.volume[p] = volume;
    model.points.mass[p] = soil.density * volume;
    model.points.velocity[2 * p] = scene.initial_velocity.x;
    model.points.velocity[2 * p + 1] = scene.initial_velocity.y;
    model.points.peak_cohesion[p] = soil.peak_cohesion;
  }
  if (!has_layers_alone)
    for (std::size_t p = 0; p < points.x.size(); ++p) model.point_soils.push_back(soil_at_point(scene, points, sample, p));
  if (scene.gravity.protocol == GravityProtocol::k0) start_from_k0(model);
  check_step(model, scene);
  return model;
}

// ---- from a run to its row ----------------------------------------------------------------------------------------------------

static Status status_of(const Outcome& outcome, bool has_reached_end, bool has_slid) {
  if (outcome.ending == Ending::diverged || !(std::abs(outcome.energy.error()) < energy_error_failure)) return Status::diverged;
  if (has_reached_end) return Status::left_domain;
  return has_slid ? Status::slid : Status::stable;
}

bool goes_on_behind(Wall wall) { return wall == Wall::roller || wall == Wall::stick; }

bool is_at_right_wall(const Scene& scene, double runout) {
  const GridShape& grid = scene.discretization.grid;
  return goes_on_behind(scene.boundaries.right) && runout > 0 && scene.slope.toe.x + runout > grid.width() - grid.cell_x;
}

Row row_of(const Scene& scene, const MaterialPoints& points, const std::optional<FieldSample>& sample, const Outcome& outcome) {
  Row row;
  row.realization = sample ? sample->realization : 0;
  row.design = sample ? sample->design : Design::plain;
  row.block = sample ? sample->block : row.realization;
  row.floored = sample ? sample->floored : 0;
  row.steps = outcome.steps;
  row.energy_error = outcome.energy.error();
  row.rest_time = outcome.rest_time;
  row.influence = row.influence_1m = row.runout = row.runout_max = row.displaced_area = std::numeric_limits<double>::quiet_NaN();
  row.status = Status::diverged;
  if (outcome.ending == Ending::diverged) return row;

  const GridShape& grid = scene.discretization.grid;
  const ReachOfRun reached = reach({outcome.points.x, outcome.points.y, points.x, points.y, outcome.points.volume},
                                   {.crest = scene.slope.crest,
                                    .toe = scene.slope.toe,
                                    .cell_x = grid.cell_x,
                                    .cell_y = grid.cell_y,
                                    .spacing_x = points.spacing_x,
                                    .spacing_y = points.spacing_y,
                                    .influence_drop = scene.output.influence_drop,
                                    .slid_displacement = scene.output.slid_displacement,
                                    .held_at_left = scene.boundaries.left == Wall::stick ? scene.slope.crest.y : 0});
  const bool has_reached_end = outcome.ending == Ending::left_domain ||
                               (goes_on_behind(scene.boundaries.left) && reached.has_reached_left_wall) ||
                               is_at_right_wall(scene, reached.runout);
  row.status = status_of(outcome, has_reached_end, reached.has_slid);
  if (row.status == Status::diverged) return row;
  row.influence = reached.influence;
  row.influence_1m = reached.influence_1m;
  row.runout = reached.runout;
  row.runout_max = reached.runout_max;
  row.displaced_area = reached.displaced_area;
  return row;
}

// ---- files on request ---------------------------------------------------------------------------------------------------------

static double displacement(const MaterialPoints& initial, const Points& now, std::size_t p) {
  return std::hypot(now.x[p] - initial.x[p], now.y[p] - initial.y[p]);
}

void write_state(const MaterialPoints& initial, const Points& now, const Provenance& provenance,
                 const std::function<void(std::string_view)>& take) {
  const auto each = [](std::span<const double> values) { return [values](std::size_t p) { return values[p]; }; };
  write_vtkhdf_points(now.x, now.y,
                      {{"displacement", [&](std::size_t p) { return displacement(initial, now, p); }},
                       {"initial_x", each(initial.x)},
                       {"initial_y", each(initial.y)},
                       {"layer", [&](std::size_t p) { return static_cast<double>(now.soil[p]); }},
                       {"peak_cohesion", each(now.peak_cohesion)},
                       {"plastic_strain", each(now.plastic_strain)},
                       {"stress_xx", each(now.xx)},
                       {"stress_xy", each(now.xy)},
                       {"stress_yy", each(now.yy)},
                       {"stress_zz", each(now.zz)},
                       {"velocity_x", [&](std::size_t p) { return now.velocity[2 * p]; }},
                       {"velocity_y", [&](std::size_t p) { return now.velocity[2 * p + 1]; }}},
                      provenance, take);
}

std::string points_table(const MaterialPoints& initial, const Points& now, const Provenance& provenance) {
  Table table({"x_m", "y_m", "x0_m", "y0_m", "plastic_strain", "displacement_m", "peak_cohesion_pa", "layer"});
  for (std::size_t p = 0; p < now.count(); ++p)
    table.add_row({format_real(now.x[p]), format_real(now.y[p]), format_real(initial.x[p]), format_real(initial.y[p]),
                   format_real(now.plastic_strain[p]), format_real(displacement(initial, now, p)), format_real(now.peak_cohesion[p]),
                   std::to_string(now.soil[p])});
  return to_tsv(table, provenance);
}

std::string profile_table(const Scene& scene, const MaterialPoints& initial, const Points& now, const Provenance& provenance) {
  const double width = scene.discretization.grid.cell_x;
  const std::vector<double> before = column_tops(initial.x, initial.y, width, initial.spacing_y);
  const std::vector<double> after = column_tops(now.x, now.y, width, initial.spacing_y);
  const auto top = [](const std::vector<double>& tops, std::size_t column) {
    return format_real(column < tops.size() ? tops[column] : std::numeric_limits<double>::quiet_NaN());
  };
  Provenance with_ends = provenance;
  with_ends.details.emplace_back("crest_m", format_real(scene.slope.crest.x));
  with_ends.details.emplace_back("toe_m", format_real(scene.slope.toe.x));
  Table table({"x_m", "surface_m", "initial_m"});
  for (std::size_t column = 0; column < std::max(before.size(), after.size()); ++column)
    table.add_row({format_real((static_cast<double>(column) + 0.5) * width), top(after, column), top(before, column)});
  return to_tsv(table, with_ends);
}

}  // namespace slidezone
