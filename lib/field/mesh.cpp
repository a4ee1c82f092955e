#include "field/mesh.hpp"

#include <algorithm>
#include <cassert>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"

namespace slidezone {

[[noreturn]] static void fail_outside(const FieldMesh& mesh, std::size_t point, double x, double y) {
  throw Error(ExitCode::data, "point " + std::to_string(point + 1) + " at (" + format_brief(x, 9) + " m, " + format_brief(y, 9) +
                                  " m) lies outside the mesh of the random field, which is " + format_brief(mesh.width(), 9) + " m x " +
                                  format_brief(mesh.height(), 9) + " m from the origin");
}

/// Cell along one axis, for 0 <= coordinate <= cell * cells.
static std::size_t cell_at(double coordinate, double cell, int cells) {
  return static_cast<std::size_t>(std::min(static_cast<int>(coordinate / cell), cells - 1));
}

std::vector<std::size_t> containing_cells(const FieldMesh& mesh, std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  std::vector<std::size_t> cells(x.size());
  for (std::size_t p = 0; p < x.size(); ++p) {
    const bool is_inside = x[p] >= 0 && x[p] <= mesh.width() && y[p] >= 0 && y[p] <= mesh.height();
    if (!is_inside) fail_outside(mesh, p, x[p], y[p]);
    const std::size_t row = cell_at(y[p], mesh.cell_y, mesh.cells_y);
    cells[p] = row * static_cast<std::size_t>(mesh.cells_x) + cell_at(x[p], mesh.cell_x, mesh.cells_x);
  }
  return cells;
}

}  // namespace slidezone
