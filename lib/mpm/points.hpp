// Material points as a struct of arrays. SI units, per metre of slope out of the plane; tension positive.
#pragma once

#include <vector>

namespace slidezone {

struct Points {
  std::vector<double> x, y;              // position, m
  std::vector<double> velocity;          // pairs (x, y) point after point, m/s
  std::vector<double> movement;          // pairs: movement of the step in progress, not yet in x and y, m
  std::vector<double> xx, yy, zz, xy;    // stress, Pa
  std::vector<double> mass;              // kg/m
  std::vector<double> volume;            // m^3/m
  std::vector<double> plastic_strain;    // equivalent plastic strain
  std::vector<double> softening_strain;  // its average over neighbours; empty where softening is local
  std::vector<double> peak_cohesion;     // Pa
  std::vector<int> soil;                 // index into the soils
  std::vector<int> label;                // the point's number at the start: points are reordered as they move

  std::size_t count() const { return x.size(); }
};

/// `count` points with everything zero and labels 0, 1, ...
Points points_at_rest(std::size_t count);

/// Puts points into the order of `order`: point k becomes what point order[k] was. One array at a time, so that a large run
/// needs little memory beside its points.
void reorder(Points& points, const std::vector<int>& order);

}  // namespace slidezone
