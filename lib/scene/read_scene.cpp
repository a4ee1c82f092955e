#include <algorithm>
#include <utility>

#include "core/provenance.hpp"
#include "io/file.hpp"
#include "io/toml.hpp"
#include "scene/read_tables.hpp"
#include "scene/scene.hpp"

namespace slidezone {

static bool has_soil_with_field(const TomlTable& file) {
  if (!file.has("soil")) return false;
  return std::ranges::any_of(file.tables("soil"), [](const TomlTable& soil) { return soil.has("field"); });
}

/// Asking for a table that is absent fails with its name.
static void check_needs(const TomlTable& file, Needs needs) {
  file.table("slope");
  if (needs.grid) file.table("grid");
  if (needs.soil) file.tables("soil");
  if (needs.time) file.table("time");
  if (needs.time) file.table("base");
  if (needs.field && !has_soil_with_field(file)) file.table("field");
  if (needs.site) file.table("site");
}

/// Ground that goes on to the right wall needs one that holds it.
static void check_right_wall(const TomlTable& slope_table, const Scene& scene) {
  if (scene.slope.surface.back().y > 0 && scene.boundaries.right == Wall::open)
    slope_table.fail("surface", scene.slope.surface.size() - 1,
                     "goes on to the right wall, which is open: soil would leave the grid there; write right = \"roller\" in [walls]");
}

Scene parse_scene(std::string_view text, const std::string& name, Needs needs) {
  const TomlTable file = TomlTable::parse(text, name);
  file.check_keys({"title", "slope", "grid", "soil", "base", "walls", "gravity", "initial", "time", "method", "nonlocal_softening", "field",
                   "output", "study", "site"});
  check_needs(file, needs);
  Scene scene;
  scene.name = name;
  scene.checksum = checksum(text);
  if (file.has("title")) scene.title = file.text("title");
  scene.slope = read_slope(file.table("slope"));
  if (file.has("grid")) scene.discretization = read_grid(file.table("grid"), file.table("slope"), scene.slope);
  if (file.has("soil")) scene.layers = read_layers(file.tables("soil"));
  if (file.has("base")) read_base(file.table("base"), scene.boundaries);
  if (file.has("walls")) read_walls(file.table("walls"), scene.boundaries);
  check_right_wall(file.table("slope"), scene);
  if (file.has("gravity")) scene.gravity = read_gravity(file.table("gravity"));
  if (file.has("initial")) scene.initial_velocity = read_initial_velocity(file.table("initial"));
  if (file.has("time")) scene.time = read_time(file.table("time"), scene.gravity);
  if (file.has("method")) scene.method = read_method(file.table("method"));
  if (file.has("nonlocal_softening")) scene.nonlocal_softening = read_nonlocal_softening(file.table("nonlocal_softening"), scene.layers);
  Fields fields = read_fields(file, scene.slope, scene.layers);
  scene.fields = std::move(fields.specs);
  scene.cross_correlations = std::move(fields.cross_correlations);
  if (file.has("output")) scene.output = read_output(file.table("output"));
  if (file.has("study")) scene.study = read_study(file.table("study"));
  if (file.has("site")) scene.site = read_site(file.table("site"));
  return scene;
}

Scene read_scene(const std::string& path, Needs needs) { return parse_scene(read_input(path), input_name(path), needs); }

}  // namespace slidezone
