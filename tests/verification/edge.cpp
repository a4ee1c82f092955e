// The longest stable step of small elastic bodies, by bisection over its part of mpm's step_limit, with the refusal of longer
// steps put aside; see pipelines/stability. Prints the table of pipelines/judge: for each kind of body the shortest of the
// edges over its places in the grid (or over seeds, for scattered points), over the limit.
//
//   edge POINTS ...      numbers of points along each axis of a cell
//
// A body gets a random velocity, so small that nothing crosses a cell. A step counts as stable where a thousand of them have
// not doubled the kinetic energy: a stable one can only hand it to elastic energy, or lose it.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>

#include "verification/bodies.hpp"

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

Model model_of(const Body& body, int points_per_cell, double poisson_ratio, unsigned seed) {
  std::mt19937_64 bits(seed);
  Model model = empty_model(12, 12, {.cell = 1, .points_per_cell = points_per_cell}, {elastic_soil(2000, 1e6, poisson_ratio)});
  const Vec2 corner{4 + body.corner, 4 + body.corner};
  add_rectangle(model, corner, body.size);
  if (body.is_scattered) {
    for (double& x : model.points.x) x = corner.x + body.size.x * uniform(bits);
    for (double& y : model.points.y) y = corner.y + body.size.y * uniform(bits);
  }
  for (double& v : model.points.velocity) v = 1e-9 * (2 * uniform(bits) - 1);
  model.gravity.acceleration = {0, 0};
  model.refuses_long_steps = false;
  return model;
}

bool is_stable(Model model, double fraction) {
  model.time.step = fraction * step_limit(model);
  model.time.end = steps * *model.time.step;
  const double before = kinetic_energy_of(model.points);
  const Outcome outcome = simulate(std::move(model));
  return outcome.ending == Ending::at_end && kinetic_energy_of(outcome.points) <= 2 * before;
}

/// To 1 %, between 0.5 and 3; 0 or infinity beyond these.
double edge_of_stability(const Model& model) {
  double low = 0.5;
  double high = 3;
  if (!is_stable(model, low)) return 0;
  if (is_stable(model, high)) return std::numeric_limits<double>::infinity();
  while (high - low > 0.01) {
    const double middle = (low + high) / 2;
    (is_stable(model, middle) ? low : high) = middle;
  }
  return low;
}

double shortest_edge(Body body, int points_per_cell, double poisson_ratio) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 10; ++k) {
    if (!body.is_scattered) body.corner = 0.1 * k;
    shortest = std::min(shortest, edge_of_stability(model_of(body, points_per_cell, poisson_ratio, static_cast<unsigned>(k + 1))));
  }
  return shortest;
}

void print_edges(int points_per_cell) {
  const auto row = [&](const char* name, Body body) {
    for (const double nu : {0.0, 0.33, 0.49})
      std::cout << "edge_" << points_per_cell << "_points\t" << name << "_nu_" << nu << "\tnan\t1\t"
                << shortest_edge(body, points_per_cell, nu) << '\n';
  };
  row("block", {.size = {4, 4}});
  row("column", {.size = {1, 4}});
  if (points_per_cell > 1) row("strip", {.size = {1.0 / points_per_cell, 4}});
  row("scattered", {.size = {3, 3}, .is_scattered = true});
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  std::cout << std::setprecision(4) << "case\tquantity\tsize\texact\tcomputed\n";
  for (int i = 1; i < argc; ++i) print_edges(std::atoi(argv[i]));
}
