#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "scene/read_tables.hpp"
#include "scene/slope.hpp"

namespace slidezone {

static const Range coefficients_of_variation{.low = 0, .high = 10, .is_low_excluded = true};
static constexpr double most_cells = 1e8;  // of a field's mesh

static std::string kilopascals(double stress) { return format_brief(stress / 1000) + " kPa"; }

/// Cells of the size `cell` that cover `length`.
static double covering_cells(double length, double cell) { return std::max(1.0, std::ceil(length / cell * (1 - same_length))); }

static void read_mesh(const TomlTable& table, const Slope& slope, FieldSpec& field) {
  const Vec2 cell = table.quantity_pair("cell", "m", positive);
  const double cells_x = covering_cells(slope.surface.back().x, cell.x);
  const double cells_y = covering_cells(slope.crest.y, cell.y);
  if (cells_x * cells_y > most_cells)
    table.fail("cell", "divides the slope into more than " + format_real(most_cells) + " cells; make it larger");
  field.cell_x = cell.x;
  field.cell_y = cell.y;
  field.cells_x = static_cast<int>(cells_x);
  field.cells_y = static_cast<int>(cells_y);
}

/// Strength never falls below the residual one: values below that floor are raised to it.
static void check_floor(const TomlTable& table, const FieldSpec& field, const std::vector<Layer>& layers) {
  for (const Layer& layer : layers)
    if (field.mean <= layer.material.residual_cohesion)
      table.fail("mean", "wants more than the residual cohesion of soil \"" + layer.name + "\", " +
                             kilopascals(layer.material.residual_cohesion) + ", the floor of the field, found " + kilopascals(field.mean));
}

static FieldSpec read_cohesion(const TomlTable& table, const Slope& slope, const std::vector<Layer>& layers) {
  table.check_keys({"mean", "cov", "marginal", "autocorrelation", "horizontal_scale", "vertical_scale", "cell"});
  FieldSpec field;
  field.parameter = "cohesion";
  field.mean = table.quantity("mean", "Pa", positive);
  field.cov = table.number("cov", coefficients_of_variation);
  field.marginal = table.choice_or("marginal", {"lognormal"}, field.marginal);
  field.autocorrelation = table.choice_or("autocorrelation", {"single exponential"}, field.autocorrelation);
  field.horizontal_scale = table.quantity("horizontal_scale", "m", positive);
  field.vertical_scale = table.quantity("vertical_scale", "m", positive);
  read_mesh(table, slope, field);
  check_floor(table, field, layers);
  return field;
}

std::vector<FieldSpec> read_fields(const TomlTable& table, const Slope& slope, const std::vector<Layer>& layers) {
  table.check_keys({"cohesion"});
  return {read_cohesion(table.table("cohesion"), slope, layers)};
}

}  // namespace slidezone
