#include <algorithm>
#include <numbers>

#include "scene/read_tables.hpp"
#include "scene/slope.hpp"

namespace slidezone {

static const Range poisson_ratios{.low = 0, .high = 0.5, .is_high_excluded = true};
static const Range acute_angles{.low = 0, .high = std::numbers::pi / 2, .is_high_excluded = true};

static double read_density(const TomlTable& table) {
  if (table.has("density") && table.has("unit_weight")) table.fail("density", "cannot stand beside 'unit_weight'; give either");
  if (table.has("density")) return table.quantity("density", "kg m-3", positive);
  return table.quantity("unit_weight", "N m-3", positive) / standard_gravity;
}

/// A key that is at most another; absent, it is `absent`.
static double at_most(const TomlTable& table, const std::string& key, const std::string& unit, double absent, double most,
                      const std::string& most_key) {
  const double value = table.quantity_or(key, unit, not_negative, absent);
  if (value > most) table.fail(key, "wants at most '" + most_key + "', found " + '"' + table.text(key) + '"');
  return value;
}

static void read_strength(const TomlTable& table, Material& soil) {
  soil.peak_cohesion = table.quantity("cohesion", "Pa", not_negative);
  soil.residual_cohesion = at_most(table, "residual_cohesion", "Pa", soil.peak_cohesion, soil.peak_cohesion, "cohesion");
  soil.peak_friction_angle = table.quantity_or("friction_angle", "rad", acute_angles, soil.peak_friction_angle);
  soil.residual_friction_angle =
      at_most(table, "residual_friction_angle", "rad", soil.peak_friction_angle, soil.peak_friction_angle, "friction_angle");
  soil.dilation_angle = at_most(table, "dilation_angle", "rad", soil.dilation_angle, soil.peak_friction_angle, "friction_angle");
  soil.tension_cutoff = table.quantity_or("tension_cutoff", "Pa", not_negative, soil.tension_cutoff);
  if (soil.peak_cohesion == 0 && soil.peak_friction_angle == 0)
    table.fail("cohesion", "wants more than 0 Pa in a soil without friction, which would have no strength at all");
}

static void read_softening(const TomlTable& table, Material& soil) {
  const bool softens = soil.residual_cohesion < soil.peak_cohesion || soil.residual_friction_angle < soil.peak_friction_angle;
  soil.softening_threshold = table.number_or("softening_threshold", not_negative, soil.softening_threshold);
  if (softens && !table.has("softening_shape"))
    table.fail(soil.residual_cohesion < soil.peak_cohesion ? "residual_cohesion" : "residual_friction_angle",
               "below the peak wants 'softening_shape' beside it, how fast strength falls with plastic strain");
  if (softens)
    soil.softening_shape = table.number("softening_shape", positive);
  else
    soil.softening_shape = table.number_or("softening_shape", not_negative, soil.softening_shape);
}

static Material read_material(const TomlTable& table) {
  Material soil;
  soil.density = read_density(table);
  soil.youngs_modulus = table.quantity("youngs_modulus", "Pa", positive);
  soil.poisson_ratio = table.number("poisson_ratio", poisson_ratios);
  read_strength(table, soil);
  read_softening(table, soil);
  return soil;
}

/// One level, "3 m", or a polyline.
static std::vector<Vec2> read_top(const TomlTable& table) {
  if (!table.is_list("top")) return {{0, table.quantity("top", "m", positive)}};
  const std::vector<Vec2> top = table.polyline("top", 2);
  if (const auto flaw = polyline_flaw(top)) table.fail("top", flaw->vertex, flaw->message);
  return top;
}

static Layer read_layer(const TomlTable& table) {
  table.check_keys({"name", "unit_weight", "density", "youngs_modulus", "poisson_ratio", "cohesion", "residual_cohesion", "friction_angle",
                    "residual_friction_angle", "dilation_angle", "tension_cutoff", "softening_threshold", "softening_shape", "top",
                    "field"});
  Layer layer;
  layer.name = table.text("name");
  if (layer.name.empty()) table.fail("name", "wants at least one letter");
  layer.material = read_material(table);
  layer.residual_cohesion_follows = !table.has("residual_cohesion");
  layer.residual_friction_follows = !table.has("residual_friction_angle");
  return layer;
}

std::vector<Layer> read_layers(const std::vector<TomlTable>& tables) {
  std::vector<Layer> layers;
  for (const TomlTable& table : tables) {
    Layer layer = read_layer(table);
    const auto has_name = [&](const Layer& other) { return other.name == layer.name; };
    if (std::any_of(layers.begin(), layers.end(), has_name))
      table.fail("name", "wants a name of its own, found \"" + layer.name + "\" twice");
    if (!layers.empty())
      layer.top = read_top(table);
    else if (table.has("top"))
      table.fail("top", "has no place in the first soil, which begins at the ground surface");
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace slidezone
