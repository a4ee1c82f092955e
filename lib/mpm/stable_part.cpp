#include "mpm/stable_part.hpp"

#include <algorithm>
#include <cmath>

namespace slidezone {

double stable_part(const Scheme& method, double half_size, double poisson_ratio) {
  const double l = method.shape_functions == ShapeFunctions::linear ? 0 : half_size;
  if (method.update_order == UpdateOrder::usl) return std::sqrt(2 * (1 - poisson_ratio) * l * (1 - l) / (2 - l));
  return std::min(1.0, 0.5 + 2 * l);
}

}  // namespace slidezone
