#include "core/round_step.hpp"

#include <cmath>

namespace slidezone {

RoundStep round_step(double limit) {
  const double exponent = std::floor(std::log10(limit));
  const double scale = std::pow(10, std::abs(exponent));
  const double mantissa = exponent < 0 ? limit * scale : limit / scale;
  const double units = mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1;
  return exponent < 0 ? RoundStep{units, scale} : RoundStep{units * scale, 1};
}

}  // namespace slidezone
