#include "field/lognormal.hpp"

#include <cmath>

#include "core/portable_math.hpp"
#include "core/vector_loop.hpp"

namespace slidezone {

Lognormal lognormal(double mean, double cov) {
  const double variance = std::log1p(cov * cov);
  return {std::log(mean) - variance / 2, std::sqrt(variance)};
}

SLIDEZONE_VECTOR_LOOP
void make_lognormal(std::span<double> values, Lognormal marginal) {
  for (double& value : values) value = portable_exp(marginal.lambda + marginal.zeta * value);
}

SLIDEZONE_VECTOR_LOOP
std::size_t raise_to_floor(std::span<double> values, double floor) {
  std::size_t count = 0;
  for (double& value : values) {
    count += value < floor ? 1 : 0;
    value = value < floor ? floor : value;
  }
  return count;
}

SLIDEZONE_VECTOR_LOOP
std::size_t lower_to_ceiling(std::span<double> values, double ceiling) {
  std::size_t count = 0;
  for (double& value : values) {
    count += value > ceiling ? 1 : 0;
    value = value > ceiling ? ceiling : value;
  }
  return count;
}

}  // namespace slidezone
