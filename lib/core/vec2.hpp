// A point or vector of the vertical plane: x to the right, y up.
#pragma once

namespace slidezone {

struct Vec2 {
  double x = 0;
  double y = 0;
};

}  // namespace slidezone
