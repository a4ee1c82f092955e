// Material points as a struct of arrays. SI units, per metre of slope out of the plane; tension positive.
//
// A run keeps what it computes with in its own precision. Positions are doubles in either: a float of metres would lose the small
// movements of a step.
#pragma once

#include <span>
#include <vector>

#include "core/large_page_allocator.hpp"

namespace slidezone {

/// Numbers of all points.
template <class Value>
using PointNumbers = std::vector<Value, LargePageAllocator<Value>>;

template <class Real>
struct PointsOf {
  PointNumbers<double> x, y;            // position, m
  PointNumbers<Real> velocity;          // pairs (x, y) point after point, m/s
  PointNumbers<Real> movement;          // pairs: movement of the step in progress, not yet in x and y, m
  PointNumbers<Real> xx, yy, zz, xy;    // stress, Pa
  PointNumbers<Real> mass;              // kg/m
  PointNumbers<Real> volume;            // m^3/m
  PointNumbers<Real> plastic_strain;    // equivalent plastic strain
  PointNumbers<Real> softening_strain;  // its average over neighbours; empty where softening is local
  PointNumbers<Real> peak_cohesion;     // Pa
  PointNumbers<int> soil;               // index into the soils
  PointNumbers<int> label;              // the point's number at the start: points are reordered as they move

  std::size_t count() const { return x.size(); }
};
using Points = PointsOf<double>;

/// The same points in another precision; those that have it already are moved.
template <class To, class From>
PointsOf<To> converted(PointsOf<From> points);

/// `count` points with everything zero and labels 0, 1, ...
Points points_at_rest(std::size_t count);

/// Puts points into the order of `order`: point k becomes what point order[k] was. One array at a time, so that a large run
/// needs little memory beside its points.
template <class Real>
void reorder(PointsOf<Real>& points, std::span<const int> order);

}  // namespace slidezone
