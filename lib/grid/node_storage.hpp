// Where the nodes of a background grid lie in memory: column by column, y fastest, one padding node below and to the left
// of the grid and enough above and to the right that the nodes of a point on the edge may be read.
#pragma once

#include <cstddef>

#include "grid/grid_shape.hpp"

namespace slidezone {

/// Node indices are (column, row), counted from the padding: grid node (i, j) is (i + padding, j + padding).
struct NodeStorage {
  static constexpr int padding = 1;
  static constexpr int spare = 4;

  explicit NodeStorage(GridShape shape) : columns(shape.cells_x + 1 + padding + spare), rows(shape.cells_y + 1 + padding + spare) {}

  int columns;
  int rows;

  std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(row);
  }
};

/// Columns and rows of nodes that material reaches, in NodeStorage counting, last excluded.
struct NodeBox {
  int first_column = 0;
  int last_column = 0;
  int first_row = 0;
  int last_row = 0;
};

}  // namespace slidezone
