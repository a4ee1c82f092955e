#include "verification/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

namespace slidezone {

Model empty_model(double width, double height, Division division, const std::vector<Material>& soils) {
  Model model;
  model.grid = {division.cell, division.cell, static_cast<int>(std::lround(width / division.cell)),
                static_cast<int>(std::lround(height / division.cell))};
  model.point_spacing_x = model.point_spacing_y = division.cell / division.points_per_cell;
  model.soils = soils;
  model.gravity.protocol = GravityProtocol::sudden;
  return model;
}

static void add_point(Points& points, double x, double y, double volume, const Material& material, int soil) {
  points.x.push_back(x);
  points.y.push_back(y);
  for (auto* pairs : {&points.velocity, &points.movement}) pairs->insert(pairs->end(), 2, 0.0);
  for (auto* values : {&points.xx, &points.yy, &points.zz, &points.xy, &points.plastic_strain}) values->push_back(0);
  points.volume.push_back(volume);
  points.mass.push_back(volume * material.density);
  points.peak_cohesion.push_back(material.peak_cohesion);
  points.soil.push_back(soil);
  points.label.push_back(static_cast<int>(points.label.size()));
}

void add_rectangle(Model& model, Vec2 corner, Vec2 size, int soil) {
  const double dx = model.point_spacing_x;
  const double dy = model.point_spacing_y;
  for (long i = 0; i < std::lround(size.x / dx); ++i)
    for (long j = 0; j < std::lround(size.y / dy); ++j)
      add_point(model.points, corner.x + (static_cast<double>(i) + 0.5) * dx, corner.y + (static_cast<double>(j) + 0.5) * dy, dx * dy,
                model.soils[static_cast<std::size_t>(soil)], soil);
}

Material elastic_soil(double density, double youngs_modulus, double poisson_ratio) {
  constexpr double never = 1e15;  // Pa
  return {.density = density,
          .youngs_modulus = youngs_modulus,
          .poisson_ratio = poisson_ratio,
          .peak_cohesion = never,
          .residual_cohesion = never};
}

double kinetic_energy_of(const Points& points) {
  double energy = 0;
  for (std::size_t p = 0; p < points.count(); ++p)
    energy += 0.5 * points.mass[p] * (std::pow(points.velocity[2 * p], 2) + std::pow(points.velocity[2 * p + 1], 2));
  return energy;
}

Scheme scheme_named(const std::string& name) {
  static const std::map<std::string, UpdateOrder> orders = {
      {"MUSL", UpdateOrder::musl}, {"USL", UpdateOrder::usl}, {"USF", UpdateOrder::usf}};
  static const std::map<std::string, ShapeFunctions> shapes = {{"GIMP", ShapeFunctions::gimp}, {"linear", ShapeFunctions::linear}};
  std::istringstream words(name);
  const auto next = [&words] {
    std::string word;
    std::getline(words, word, '_');
    return word;
  };
  Scheme scheme{.update_order = orders.at(next()), .shape_functions = shapes.at(next())};
  for (std::string word = next(); !word.empty(); word = next()) {
    if (word == "B-bar")
      scheme.anti_locking = AntiLocking::b_bar;
    else if (word == "single")
      scheme.precision = Precision::single_precision;
    else
      throw std::out_of_range(word);
  }
  return scheme;
}

}  // namespace slidezone
