// Bodies for the verification programs, where no scene can express a case: rectangles of material points anywhere in a grid.
#pragma once

#include <string>
#include <vector>

#include "mpm/simulation.hpp"

namespace slidezone {

/// How a rectangle is divided: square cells and points along each axis of a cell.
struct Division {
  double cell = 0;  // m
  int points_per_cell = 2;
};

/// A model without points, under sudden gravity, whose grid covers width x height metres.
Model empty_model(double width, double height, Division division, const std::vector<Material>& soils);

/// Adds a rectangle of soil number `soil` at rest and free of stress; its sides fall on whole numbers of point spacings.
void add_rectangle(Model& model, Vec2 corner, Vec2 size, int soil = 0);

/// A soil that never yields.
Material elastic_soil(double density, double youngs_modulus, double poisson_ratio);

double kinetic_energy_of(const Points& points);

/// A method by its name: update order and shape functions as scenes call them, then B-bar and single if wanted, like "MUSL_GIMP" and
/// "USL_GIMP_B-bar_single". Throws std::out_of_range for a name that does not exist.
Scheme scheme_named(const std::string& name);

}  // namespace slidezone
