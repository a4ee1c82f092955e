// The least value of a function of a few variables by the simplex of Nelder and Mead (1965), GSL's nmsimplex2.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace slidezone {

struct Minimum {
  std::vector<double> place;
  double value = 0;
};

/// From `start`, with first steps of `step` in each direction, until the simplex is smaller than 1e-9. Infinite values of the function
/// keep the search out; it must be finite at the start.
Minimum minimum_by_simplex(const std::function<double(std::span<const double>)>& function, std::span<const double> start, double step);

}  // namespace slidezone
