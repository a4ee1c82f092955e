// The background grid: equal rectangular cells from the corner where the left wall meets the base.
//
// Node (i, j) lies at (i cell_x, j cell_y), 0 <= i <= cells_x, 0 <= j <= cells_y. Lengths in metres.
#pragma once

namespace slidezone {

struct GridShape {
  double cell_x = 0;
  double cell_y = 0;
  int cells_x = 0;
  int cells_y = 0;

  double width() const { return cell_x * cells_x; }
  double height() const { return cell_y * cells_y; }
};

}  // namespace slidezone
