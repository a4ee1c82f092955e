// What of a scene is possible, and most likely not meant or not good: to be said before the run. SI units.
//
//   weight     below 2 or above 50 kN/m^3: no soil, but a slip of a thousand in the unit
//   friction   a coefficient above 2 on the base, 63 degrees: an angle in degrees in place of its tangent
//   locking    Poisson's ratio above 0.45 without B-bar: cells are far too stiff, and a slope stands that should slide
//              (pipelines/verification/README.md)
//   averaging  nonlocal softening over less than two spacings of the points: it hardly averages, and results depend on the cells
//   yielding   a cohesion above a tenth of Young's modulus: soil that gives way at no strain that a slope sees
//   settlement what soil settles under its weight without failing, by more than half of the displacement that counts as a slide, or
//              that differs along the ground by more than half of the drop that counts as failed
//   crest      the highest vertex, when the edge that is meant lies farther right: ground that falls next to nothing beside it
//   means      a value of a soil that differs by more than a tenth from the mean of its field
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace slidezone {

struct Doubts {
  std::vector<std::string> warnings;
  std::vector<std::string> notes;  // what is meant at times: a body that is to stay elastic
};

Doubts doubts_on(const Scene& scene);

/// Warnings of settlement: sum of sigma / M over each column of points, sigma its weight above and M the constrained modulus.
std::vector<std::string> doubts_on_settlement(const Scene& scene, const MaterialPoints& points);

/// What the deterministic run has otherwise than random ones have on average.
std::vector<std::string> differences_of_means(const Scene& scene);

}  // namespace slidezone
