// The mesh of a random field: equal rectangular cells from the origin, one value each.
//
// Cell (i, j) covers [i cell_x, (i+1) cell_x] x [j cell_y, (j+1) cell_y], with its centre at ((i + 1/2) cell_x, (j + 1/2) cell_y).
// Values lie row by row from the base up: index j cells_x + i. Lengths in metres.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace slidezone {

struct FieldMesh {
  double cell_x = 0;
  double cell_y = 0;
  int cells_x = 0;
  int cells_y = 0;

  double width() const { return cell_x * cells_x; }
  double height() const { return cell_y * cells_y; }
  std::size_t size() const { return static_cast<std::size_t>(cells_x) * static_cast<std::size_t>(cells_y); }
  bool operator==(const FieldMesh&) const = default;
};

/// Index of the cell that contains each point; the far edges belong to the last cells.
/// Throws ExitCode::data for a point outside the mesh, with its number (counted from 1) and coordinates.
std::vector<std::size_t> containing_cells(const FieldMesh& mesh, std::span<const double> x, std::span<const double> y);

/// Four cells whose centres surround a point, and their shares in a value that is linear between them.
struct Neighbours {
  std::array<std::size_t, 4> cells;
  std::array<double, 4> weights;  // their sum is 1
};

/// For each point; beyond the outermost centres the value stays that at the nearest place between them. Throws as above.
std::vector<Neighbours> neighbours(const FieldMesh& mesh, std::span<const double> x, std::span<const double> y);

}  // namespace slidezone
