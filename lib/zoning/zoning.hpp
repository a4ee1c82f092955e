// Hazard zones: exceedance curves, boundaries of classes, classes of structures.
//
// A place at distance d from the toe (the crest) is reached where the limit state G = d - R (d - I) is negative (Eqs. 1-4), so its
// hazard is P(R > d), a share of all realizations, failed or not. Distances in m, counted away from the slope; probabilities 0..1.
//
// Classes: zones between distances at which P(reach > d) falls to 50, 10, 1 and 0.1 %:
//   very_high  P > 0.5      high  0.1 < P <= 0.5      medium  0.01 < P <= 0.1      low  0.001 < P <= 0.01      very_low  P <= 0.001
// The boundary of a class is its far end; very_low has none. A sample of n runs knows a boundary p only where some n p >= 4 runs lie
// beyond it (95 %): otherwise its interval has no upper end.
// Bands are pointwise (each holds for one distance alone with 95 %) or simultaneous (for the whole curve at once); see stats/interval.hpp.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "stats/distribution.hpp"
#include "stats/sample.hpp"
#include "stats/tail.hpp"

namespace slidezone {

/// Classes from the most to the least hazardous; names are one more than thresholds.
struct Classes {
  std::vector<double> thresholds = {0.5, 0.1, 0.01, 0.001};  // exceedance probability at the far end
  std::vector<std::string> names = {"very_high", "high", "medium", "low", "very_low"};
};

/// The class of a place with this probability of being reached; "unknown" for nan.
const std::string& class_of(const Classes& classes, double probability);

struct Boundary {
  std::string name;  // of the class that ends here
  double probability = 0;
  Estimate distance;
};

std::vector<Boundary> boundaries(const Sample& sample, const Classes& classes);

/// The same, but boundaries with a probability below the tail's share come from the tail's fit to the sample's known values.
std::vector<Boundary> boundaries_by_tail(const Sample& sample, const Classes& classes, const TailFit& tail);

struct CurvePoint {
  double distance = 0;
  Estimate exceedance;
  double normal = 0;     // P(failure) times the tail of the Normal fit to the slides; nan where there is none
  double lognormal = 0;  // likewise
};

/// The curve over given distances. `of_slides` are the values to fit, `failure` is P(failure).
std::vector<CurvePoint> exceedance_curve(const Sample& sample, std::span<const double> of_slides, double failure,
                                         std::span<const double> distances, Band band = Band::exact);

/// Evenly spaced distances from 0 to at least 1.25 times the farthest value; the step is 1, 2 or 5 times a power of ten, for 200 to 500
/// steps.
std::vector<double> curve_distances(double farthest);

}  // namespace slidezone
