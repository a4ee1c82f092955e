// The places of a few points that leave a method the shortest stable step, by the spectrum of the step (spectrum.hpp): random
// sets of 1 to 10 points, from each of which one point after the other is moved at random as long as that shortens the step. Prints a
// table for pipelines/judge, the step over mpm's step_limit; see pipelines/stability.
//
//   worst_edge METHOD POINTS      METHOD like MUSL_GIMP, number of points along each axis of a cell (of the size of their domains)
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

constexpr int sets = 12;
constexpr int moves = 600;

/// A number in [0, 1), the same on every machine.
double uniform(std::mt19937_64& bits) { return static_cast<double>(bits() >> 11) * 0x1p-53; }

Model random_set(const Scheme& method, int points_per_cell, double poisson_ratio, std::mt19937_64& bits) {
  Model model = empty_model(12, 12, {.cell = 1, .points_per_cell = points_per_cell}, {elastic_soil(2000, 1e6, poisson_ratio)});
  model.method = method;
  const double count = std::floor(1 + 10 * uniform(bits));
  const double span = 0.5 + 2.5 * uniform(bits);
  add_rectangle(model, {0, 0}, {count / points_per_cell, 1.0 / points_per_cell});
  for (double& x : model.points.x) x = 4 + span * uniform(bits);
  for (double& y : model.points.y) y = 4 + span * uniform(bits);
  return model;
}

/// The set with one point moved, by a distance between a hundredth of a cell and half of one.
Model moved(Model model, std::mt19937_64& bits) {
  const auto p = static_cast<std::size_t>(uniform(bits) * static_cast<double>(model.points.count()));
  const double distance = std::pow(0.01, uniform(bits));
  model.points.x[p] += distance * (uniform(bits) - 0.5);
  model.points.y[p] += distance * (uniform(bits) - 0.5);
  return model;
}

double shortest_from(Model model, std::mt19937_64& bits) {
  double shortest = longest_stable_step(model);
  for (int k = 0; k < moves; ++k) {
    Model other = moved(model, bits);
    const double step = longest_stable_step(other);
    if (step >= shortest) continue;
    shortest = step;
    model = std::move(other);
  }
  return shortest / step_limit(model);
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  if (argc != 3) return 64;
  const int points_per_cell = std::atoi(argv[2]);
  std::cout << std::setprecision(4) << "case\tquantity\tsize\texact\tcomputed\n";
  for (const double nu : {0.0, 0.33, 0.4999}) {
    std::mt19937_64 bits(1);
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < sets; ++k)
      shortest = std::min(shortest, shortest_from(random_set(scheme_named(argv[1]), points_per_cell, nu, bits), bits));
    std::cout << argv[1] << '_' << points_per_cell << "\tworst_places\t" << nu << "\tnan\t" << shortest << '\n';
  }
}
