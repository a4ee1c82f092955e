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

static bool contains(const FieldMesh& mesh, double x, double y) { return x >= 0 && x <= mesh.width() && y >= 0 && y <= mesh.height(); }

std::vector<std::size_t> containing_cells(const FieldMesh& mesh, std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  std::vector<std::size_t> cells(x.size());
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (!contains(mesh, x[p], y[p])) fail_outside(mesh, p, x[p], y[p]);
    const std::size_t row = cell_at(y[p], mesh.cell_y, mesh.cells_y);
    cells[p] = row * static_cast<std::size_t>(mesh.cells_x) + cell_at(x[p], mesh.cell_x, mesh.cells_x);
  }
  return cells;
}

/// The cell whose centre lies last before the coordinate, its neighbour after it, and the neighbour's share.
struct Between {
  std::size_t before, after;
  double share;
};

static Between between(double coordinate, double cell, int cells) {
  const double place = std::clamp(coordinate / cell - 0.5, 0.0, static_cast<double>(cells - 1));
  const auto before = static_cast<std::size_t>(place);
  return {before, std::min(before + 1, static_cast<std::size_t>(cells - 1)), place - static_cast<double>(before)};
}

std::vector<Neighbours> neighbours(const FieldMesh& mesh, std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  const auto columns = static_cast<std::size_t>(mesh.cells_x);
  std::vector<Neighbours> all(x.size());
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (!contains(mesh, x[p], y[p])) fail_outside(mesh, p, x[p], y[p]);
    const Between i = between(x[p], mesh.cell_x, mesh.cells_x), j = between(y[p], mesh.cell_y, mesh.cells_y);
    all[p] = {{j.before * columns + i.before, j.before * columns + i.after, j.after * columns + i.before, j.after * columns + i.after},
              {(1 - i.share) * (1 - j.share), i.share * (1 - j.share), (1 - i.share) * j.share, i.share * j.share}};
  }
  return all;
}

}  // namespace slidezone
