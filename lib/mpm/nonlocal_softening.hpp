// Softening by a strain that is averaged over neighbours, so that shear bands have a width of the material's and not of the grid's.
//
// Over-nonlocal average (Vermeer and Brinkgreve 1994) over the initial positions of the points:
//   v  = min(e, e_0 + 4 / eta)                          e the equivalent plastic strain; softening is complete there
//   v~ = sum_q w(|X_p - X_q|) v_q / sum_q w(|X_p - X_q|),   w Gaussian, standard deviation length / 2, cut off at 3 of them
//   e_s = max(e_s, m v~ + (1 - m) v)                    strength is not regained
// The sums run over the points of the same soil. The cap keeps the very large strains within bands from softening all around
// them; m > 1 keeps bands from widening with the mesh size (m = 1, the plain average, does not converge).
// Accuracy: benchmark slope, see README. The average lags behind by at most `interval`.
#pragma once

#include <cstddef>
#include <vector>

#include "mpm/points.hpp"
#include "mpm/settings.hpp"
#include "soil/material.hpp"

namespace slidezone {

/// Averages by two passes, along x and along y, over the lattice of initial positions.
class NonlocalAverage {
 public:
  /// `points` in their initial positions, a lattice of the given spacing.
  template <class Real>
  NonlocalAverage(const PointsOf<Real>& points, const std::vector<Material>& soils, double spacing_x, double spacing_y,
                  NonlocalSoftening settings);

  /// Raises `softening_strain` to the average of the points' plastic strain; both in the order of `points` now.
  template <class Real>
  void update(const PointsOf<Real>& points, PointNumbers<Real>& softening_strain);

  /// Longest time between updates that stays within the accuracy stated above.
  static constexpr double interval = 8e-3;  // s

 private:
  struct Kernel {
    std::vector<double> weights;  // of distances 0, 1, ... spacings
  };
  std::vector<double> smoothed(const std::vector<double>& values) const;

  NonlocalSoftening settings_;
  std::vector<double> caps_;  // of v, by soil
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::size_t> place_;              // on the lattice, by label
  std::vector<int> soil_;                       // by label
  std::vector<std::vector<double>> occupancy_;  // smoothed, by soil
  Kernel along_x_;
  Kernel along_y_;
};

}  // namespace slidezone
