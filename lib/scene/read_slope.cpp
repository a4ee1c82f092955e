#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/text.hpp"
#include "scene/read_tables.hpp"
#include "scene/slope.hpp"

namespace slidezone {

static const Range up_to_vertical{.low = 0, .high = std::numbers::pi / 2, .is_low_excluded = true};

static std::string metres(double length) { return format_brief(length, 9) + " m"; }

// ---- [slope] ----

static Slope read_straight_slope(const TomlTable& table) {
  const double height = table.quantity("height", "m", positive);
  const double length = table.quantity("length", "m", positive);
  const double angle = table.quantity("angle", "rad", up_to_vertical);
  const std::vector<Vec2> surface = straight_slope(height, length, angle);
  const double face = length - surface[1].x;
  if (face > length * (1 - same_length))
    table.fail("length", "wants more than the " + metres(face) + " that the face takes, found " + metres(length));
  return slope_of(surface);
}

Slope read_slope(const TomlTable& table) {
  table.check_keys({"surface", "height", "length", "angle"});
  if (!table.has("surface")) return read_straight_slope(table);
  for (const std::string key : {"height", "length", "angle"})
    if (table.has(key)) table.fail(key, "cannot stand beside 'surface'; give either");
  const std::vector<Vec2> surface = table.polyline("surface", 2);
  if (const auto flaw = surface_flaw(surface)) table.fail("surface", flaw->vertex, flaw->message);
  return slope_of(surface);
}

// ---- [grid] ----

static constexpr std::uint64_t most_points_per_cell = 8;  // along each axis
static constexpr double most_cells = 1e8;                 // of the whole grid: beyond any memory that would hold its points

/// The number of cells in `length`, which must be whole.
static int cell_count(const TomlTable& table, const std::string& key, double cell) {
  const double length = table.quantity(key, "m", positive);
  const double count = std::round(length / cell);
  if (count > most_cells) table.fail(key, "holds more than " + format_real(most_cells) + " cells of " + metres(cell));
  if (count < 1 || std::abs(count * cell - length) > same_length * length)
    table.fail(key, "wants a whole number of cells of " + metres(cell) + ", found " + metres(length) + "; the nearest is " +
                        metres(std::max(count, 1.0) * cell));
  return static_cast<int>(count);
}

static GridShape read_shape(const TomlTable& table) {
  const Vec2 cell = table.quantity_pair("cell", "m", positive);
  const GridShape grid{cell.x, cell.y, cell_count(table, "width", cell.x), cell_count(table, "height", cell.y)};
  if (static_cast<double>(grid.cells_x) * grid.cells_y > most_cells)
    table.fail("cell", "divides the grid into more than " + format_real(most_cells) + " cells; make it larger");
  return grid;
}

static void check_fit(const TomlTable& table, const TomlTable& slope_table, const Slope& slope, const GridShape& grid) {
  const Vec2 end = slope.surface.back();
  const double room = same_length * grid.width();
  if (end.x > grid.width() + room) table.fail("width", "wants at least the slope's " + metres(end.x) + ", found " + metres(grid.width()));
  if (end.y > 0 && end.x < grid.width() - room)
    slope_table.fail("surface", slope.surface.size() - 1,
                     "ends in the air at x = " + metres(end.x) +
                         "; wants its last point on the base, y = 0 m, or at the right wall, x = " + metres(grid.width()));
  if (slope.crest.y + grid.cell_y > grid.height() * (1 + same_length))
    table.fail("height",
               "wants at least " + metres(slope.crest.y + grid.cell_y) + ", a cell above the slope, found " + metres(grid.height()));
}

/// The first elevation at which the surface is level but not at a whole number of spacings.
static std::optional<double> broken_level(const std::vector<Vec2>& surface, double spacing) {
  for (std::size_t i = 1; i < surface.size(); ++i) {
    const double rows = surface[i].y / spacing;
    if (surface[i].y == surface[i - 1].y && std::abs(rows - std::round(rows)) > same_length * rows) return surface[i].y;
  }
  return std::nullopt;
}

Discretization read_grid(const TomlTable& table, const TomlTable& slope_table, const Slope& slope) {
  table.check_keys({"cell", "width", "height", "points_per_cell"});
  Discretization discretization;
  discretization.grid = read_shape(table);
  const auto absent = static_cast<std::uint64_t>(discretization.points_per_cell);
  discretization.points_per_cell = static_cast<int>(table.whole_or("points_per_cell", 1, most_points_per_cell, absent));
  check_fit(table, slope_table, slope, discretization.grid);
  const double spacing = discretization.grid.cell_y / discretization.points_per_cell;
  if (const auto level = broken_level(slope.surface, spacing))
    table.fail("cell", "wants level ground at a whole number of point spacings, found it at " + metres(*level) + " with points every " +
                           metres(spacing) + "; change the cell or points_per_cell");
  return discretization;
}

}  // namespace slidezone
