#include "realization/doubts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "soil/elasticity.hpp"
#include "soil/parameter.hpp"

namespace slidezone {

static constexpr double least_weight = 2e3, most_weight = 50e3;  // N/m^3
static constexpr double most_friction = 2;
static constexpr double most_poisson_ratio = 0.45;
static constexpr double least_length = 2;       // spacings of points
static constexpr double most_cohesion = 0.1;    // of Young's modulus
static constexpr double most_difference = 0.1;  // of the mean
static constexpr double least_fall = 0.25;      // of the mean inclination from crest to toe
static constexpr double most_settlement = 0.5;  // of the displacement, or the drop, that counts

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

/// The ground right of the crest, where it is much flatter than the way down to the toe.
static void look_at_crest(Doubts& doubts, const Slope& slope) {
  const auto is_crest = [&](const Vec2& vertex) { return vertex.x == slope.crest.x && vertex.y == slope.crest.y; };
  const auto crest = std::ranges::find_if(slope.surface, is_crest);
  if (crest == slope.surface.end() || crest + 1 == slope.surface.end()) return;
  const Vec2 next = crest[1];
  const double fall = slope.crest.y - next.y;
  const double length = next.x - slope.crest.x;
  if (fall * (slope.toe.x - slope.crest.x) >= least_fall * length * (slope.crest.y - slope.toe.y)) return;
  doubts.warnings.push_back("influence counts from the crest, the last of the highest vertices, at x = " + format_brief(slope.crest.x) +
                            " m, and the ground falls by only " + format_brief(fall, 3) + " m over the " + format_brief(length, 3) +
                            " m right of it; where the edge at x = " + format_brief(next.x) +
                            " m is meant, make it as high as the ground behind it");
}

Doubts doubts_on(const Scene& scene) {
  Doubts doubts;
  look_at_crest(doubts, scene.slope);
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

/// Of each column of points, from the left.
static std::vector<double> settlements(const Scene& scene, const MaterialPoints& points) {
  std::vector<double> sums;
  double above = 0;  // stress by the points above, Pa
  for (std::size_t p = points.x.size(); p-- > 0;) {
    const bool is_top = p + 1 == points.x.size() || points.x[p + 1] != points.x[p];
    if (is_top) sums.push_back(above = 0);
    const Material& soil = scene.layers[static_cast<std::size_t>(points.layer[p])].material;
    const double own = soil.density * -scene.gravity.acceleration.y * points.spacing_y;
    sums.back() += (above + 0.5 * own) / constrained_modulus(soil) * points.spacing_y;
    above += own;
  }
  std::reverse(sums.begin(), sums.end());
  return sums;
}

std::vector<std::string> doubts_on_settlement(const Scene& scene, const MaterialPoints& points) {
  std::vector<std::string> warnings;
  if (scene.gravity.protocol == GravityProtocol::k0) return warnings;  // it has settled
  std::vector<double> of_columns = settlements(scene, points);
  const double most = *std::ranges::max_element(of_columns);
  if (most > most_settlement * scene.output.slid_displacement)
    warnings.push_back("soil settles by " + format_brief(most, 3) +
                       " m under its weight without failing, and what moves by slid_displacement, " +
                       format_brief(scene.output.slid_displacement) + " m, counts as slid; raise it in [output]");
  of_columns.resize(std::min(of_columns.size(), static_cast<std::size_t>(std::ceil(scene.slope.crest.x / points.spacing_x))));
  const auto [least, greatest] = std::ranges::minmax_element(of_columns);
  if (*greatest - *least > most_settlement * scene.output.influence_drop)
    warnings.push_back("the ground behind the crest settles unevenly, by " + format_brief(*least, 3) + " to " + format_brief(*greatest, 3) +
                       " m, without failing, and what drops by influence_drop, " + format_brief(scene.output.influence_drop) +
                       " m, beyond the left-most column counts as failed; raise it in [output]");
  return warnings;
}

std::vector<std::string> differences_of_means(const Scene& scene) {
  std::vector<std::string> notes;
  for (const FieldSpec& spec : scene.fields) compare_means(notes, spec, scene);
  return notes;
}

}  // namespace slidezone
