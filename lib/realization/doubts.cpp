#include "realization/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "soil/parameter.hpp"

namespace slidezone {

static constexpr double least_weight = 2e3, most_weight = 50e3;  // N/m^3
static constexpr double most_friction = 2;
static constexpr double most_poisson_ratio = 0.45;
static constexpr double least_length = 2;       // spacings of points
static constexpr double most_cohesion = 0.1;    // of Young's modulus
static constexpr double most_difference = 0.1;  // of the mean

static std::string kilo(double value, const std::string& unit) { return format_brief(value / 1000, 6) + " k" + unit; }

/// Of a field that has one mean at every depth.
static void compare_means(std::vector<std::string>& notes, const FieldSpec& spec, const Scene& scene) {
  if (spec.model.marginal.distribution == Distribution::empirical || spec.model.trend.gradient != 0) return;
  for (const std::size_t soil : spec.soils) {
    const Layer& layer = scene.layers[soil];
    const double part = value_of(layer.material, spec.parameter) / spec.model.marginal.mean;
    if (std::abs(part - 1) > most_difference)
      notes.push_back("soil \"" + layer.name + "\" has " + format_brief(part, 3) + " times the mean of its field " + spec.name +
                      ": that is what realization 0, this run, has");
  }
}

Doubts doubts_on(const Scene& scene) {
  Doubts doubts;
  for (const Layer& layer : scene.layers) {
    const Material& soil = layer.material;
    const std::string name = "soil \"" + layer.name + "\"";
    const double weight = value_of(soil, Parameter::unit_weight);
    if (weight < least_weight || weight > most_weight)
      doubts.warnings.push_back(name + " weighs " + kilo(weight, "N/m^3") + "; is the unit right?");
    if (soil.poisson_ratio > most_poisson_ratio && scene.method.anti_locking == AntiLocking::none)
      doubts.warnings.push_back("cells lock in " + name + " with its Poisson's ratio of " + format_brief(soil.poisson_ratio) + ", above " +
                                format_brief(most_poisson_ratio) + ": write anti_locking = \"B-bar\" in [method]");
    if (soil.peak_cohesion > most_cohesion * soil.youngs_modulus)
      doubts.notes.push_back(name + " hardly ever yields: its cohesion is " + kilo(soil.peak_cohesion, "Pa") + ", its Young's modulus " +
                             kilo(soil.youngs_modulus, "Pa"));
  }
  const double friction = scene.boundaries.base_friction;
  if (friction > most_friction)
    doubts.warnings.push_back("friction on the base is a coefficient, the tangent of an angle: " + format_brief(friction) + " is that of " +
                              format_brief(std::atan(friction) * 180 / std::numbers::pi, 3) + " degrees");
  const double spacing =
      std::max(scene.discretization.grid.cell_x, scene.discretization.grid.cell_y) / scene.discretization.points_per_cell;
  if (scene.nonlocal_softening && scene.nonlocal_softening->length < least_length * spacing)
    doubts.warnings.push_back("nonlocal softening over " + format_brief(scene.nonlocal_softening->length) +
                              " m hardly averages where points lie " + format_brief(spacing) +
                              " m apart: take at least two spacings, or results depend on the cells");
  return doubts;
}

std::vector<std::string> differences_of_means(const Scene& scene) {
  std::vector<std::string> notes;
  for (const FieldSpec& spec : scene.fields) compare_means(notes, spec, scene);
  return notes;
}

}  // namespace slidezone
