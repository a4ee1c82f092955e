// When a slope has come to rest.
//
// Two things must stay below a fraction of their peaks: kinetic energy on the grid (that of the points never vanishes: part of
// it is null-space noise of the interpolation) and growth of plastic strain, by mass. Neither does alone: soil that creeps towards
// a failure hardly moves, and what slides on a base need not yield.
#pragma once

#include "mpm/points.hpp"
#include "mpm/settings.hpp"

namespace slidezone {

class RestWatch {
 public:
  explicit RestWatch(RestRule rule) : rule_(rule) {}

  /// After each step: `kinetic` of the grid, J/m. Strain is looked at ten times in the time that the rule holds.
  template <class Real>
  void see(double time, double kinetic, const PointsOf<Real>& points);

  /// The last time that the slope moved or strained by more than the rule's fractions of the peaks, s.
  double moving_until() const { return moving_until_; }

 private:
  RestRule rule_;
  double most_kinetic_ = 0;
  double most_growth_ = 0;  // of strain, from look to look
  double strain_ = 0;
  double next_look_ = 0;  // s
  double moving_until_ = 0;
};

}  // namespace slidezone
