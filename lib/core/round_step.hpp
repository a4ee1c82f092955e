// Round steps for axes, bins and grids: 1, 2 or 5 times a power of ten, whose multiples are the decimal numbers they look like.
#pragma once

namespace slidezone {

/// The step numerator / denominator, one of which is a power of ten or 1.
struct RoundStep {
  double numerator = 1;
  double denominator = 1;

  /// count * step, rounded once: 3 * 1 / 10 is 0.3, whereas 3 * 0.1 is not.
  double multiple(double count) const { return count * numerator / denominator; }
};

/// The largest round step that is at most `limit` > 0.
RoundStep round_step(double limit);

}  // namespace slidezone
