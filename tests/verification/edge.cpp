// The longest stable step of small elastic bodies: found by bisection, with the refusal of long steps put aside, and as the
// spectrum of the step has it (spectrum.hpp). See pipelines/stability. Prints a table for pipelines/judge: exact is the
// spectrum's, computed is found, both over mpm's step_limit; and beside that the body and the limit over cell / wave speed.
//
//   edge METHOD POINTS      METHOD like MUSL_GIMP or USL_GIMP_B-bar, number of points along each axis of a cell
//
// Bodies lie at ten places in the grid each, or have their points scattered in ten ways; of each the shortest edge is told.
// A body gets random velocities and stresses, so small that nothing crosses a cell; no point lies on the edge of one, for there
// the slopes of linear shape functions jump. A step counts as stable where a thousand of them never multiply the kinetic and
// elastic energy by 10^4: just below the edge some movements grow for a while, to 1 / (1 - (step / edge)^2) times their energy;
// beyond it they grow by some per cent in each step.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <limits>
#include <random>
#include <string>

#include "verification/bodies.hpp"
#include "verification/spectrum.hpp"

namespace slidezone {
namespace {

constexpr int steps = 1000;

/// A number in [0, 1), the same on every machine.
double uniform(std::mt19937_64& bits) { return static_cast<double>(bits() >> 11) * 0x1p-53; }

struct Body {
  Vec2 size;          // in cells
  double corner = 0;  // place of its corner in a cell, along both axes
  bool is_scattered = false;
};

Model model_of(const Body& body, const Scheme& method, int points_per_cell, double poisson_ratio, unsigned seed) {
  std::mt19937_64 bits(seed);
  Model model = empty_model(12, 12, {.cell = 1, .points_per_cell = points_per_cell}, {elastic_soil(2000, 1e6, poisson_ratio)});
  model.method = method;
  const Vec2 corner{4 + body.corner, 4 + body.corner};
  add_rectangle(model, corner, body.size);
  if (body.is_scattered) {
    for (double& x : model.points.x) x = corner.x + body.size.x * uniform(bits);
    for (double& y : model.points.y) y = corner.y + body.size.y * uniform(bits);
  }
  for (double& v : model.points.velocity) v = 1e-9 * (2 * uniform(bits) - 1);
  for (auto* stresses : {&model.points.xx, &model.points.yy, &model.points.zz, &model.points.xy})
    for (double& stress : *stresses) stress = 1e-5 * (2 * uniform(bits) - 1);  // some v sqrt(rho M), a wave's
  model.gravity.acceleration = {0, 0};
  model.refuses_long_steps = false;
  return model;
}

/// Kinetic and elastic energy, J/m.
double energy_of(const Points& points, const Material& soil) {
  const ElasticModuli moduli = elastic_moduli(soil);
  double energy = kinetic_energy_of(points);
  for (std::size_t p = 0; p < points.count(); ++p) {
    const double mean = (points.xx[p] + points.yy[p] + points.zz[p]) / 3;
    const double shear = 0.5 * (std::pow(points.xx[p] - mean, 2) + std::pow(points.yy[p] - mean, 2) + std::pow(points.zz[p] - mean, 2)) +
                         std::pow(points.xy[p], 2);
    energy += points.volume[p] * 0.5 * (mean * mean / moduli.bulk + shear / moduli.shear);
  }
  return energy;
}

bool is_stable(Model model, double step) {
  model.time.step = step;
  model.time.end = steps * step;
  const Material soil = model.soils.front();
  const double most = 1e4 * energy_of(model.points, soil);
  bool has_grown = false;
  const auto look = [&](const Moment& moment) {
    if (moment.step % 5 == 0) has_grown |= energy_of(moment.points(), soil) > most;
  };
  return simulate(std::move(model), look).ending == Ending::at_end && !has_grown;
}

/// To 1 %, between 0.5 and 4 times the limit; 0 or infinity beyond these.
double edge_of_stability(const Model& model) {
  double low = 0.5 * step_limit(model);
  double high = 8 * low;
  if (!is_stable(model, low)) return 0;
  if (is_stable(model, high)) return std::numeric_limits<double>::infinity();
  while (high - low > 0.01 * low) {
    const double middle = (low + high) / 2;
    (is_stable(model, middle) ? low : high) = middle;
  }
  return low;
}

/// In parts of the limit.
struct Edges {
  double in_theory = std::numeric_limits<double>::infinity();
  double found = std::numeric_limits<double>::infinity();
};

Edges shortest_edges(Body body, const Scheme& method, int points_per_cell, double poisson_ratio) {
  Edges shortest;
  for (int k = 0; k < 10; ++k) {
    if (!body.is_scattered) body.corner = 0.03 + 0.1 * k;
    const Model model = model_of(body, method, points_per_cell, poisson_ratio, static_cast<unsigned>(k + 1));
    shortest.in_theory = std::min(shortest.in_theory, longest_stable_step(model) / step_limit(model));
    shortest.found = std::min(shortest.found, edge_of_stability(model) / step_limit(model));
  }
  return shortest;
}

/// The limit over cell / wave speed, for cells of 1 m.
double limit_part(const Scheme& method, int points_per_cell, double poisson_ratio) {
  const Model model = model_of({.size = {1, 1}}, method, points_per_cell, poisson_ratio, 1);
  const Material& soil = model.soils.front();
  return step_limit(model) * std::sqrt(constrained_modulus(soil) / soil.density);
}

void print_edges(const std::string& name, int points_per_cell) {
  const Scheme method = scheme_named(name);
  const auto rows = [&](const char* body_name, const Body& body) {
    for (const double nu : {0.0, 0.33, 0.49}) {
      const Edges edges = shortest_edges(body, method, points_per_cell, nu);
      std::cout << name << '_' << points_per_cell << "\tedge\t" << nu << '\t' << edges.in_theory << '\t' << edges.found << '\t' << body_name
                << '\t' << limit_part(method, points_per_cell, nu) << '\n';
    }
  };
  rows("block", {.size = {4, 4}});
  rows("column", {.size = {1, 4}});
  if (points_per_cell > 1) rows("strip", {.size = {1.0 / points_per_cell, 4}});
  rows("scattered", {.size = {3, 3}, .is_scattered = true});
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  if (argc != 3) return 64;
  std::cout << std::setprecision(4) << "case\tquantity\tsize\texact\tcomputed\tbody\tlimit_part\n";
  slidezone::print_edges(argv[1], std::atoi(argv[2]));
}
