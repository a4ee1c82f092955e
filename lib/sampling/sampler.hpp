// The random fields of a scene, ready to draw: their plans (field/random_fields.hpp), held to the limits of the scene's soils
// (scene/varied_soil.hpp) and to the measurements that the scene names.
//
// Tables of measurements: "slidezone-measurements 1", data-schemas/measurements.json. Errors name the scene and the field, or the
// table's line.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "field/random_fields.hpp"
#include "scene/scene.hpp"

namespace slidezone {

struct Sampler {
  RandomFields fields;                                       // in the order of Scene::fields
  std::vector<std::pair<std::string, std::string>> details;  // for provenance: checksums of tables of measurements
};

/// As the scene has them, by its design.
Sampler sampler_of(const Scene& scene, std::uint64_t seed);

/// Without measurements, each sample by itself: stationary and independent, to be held against theory.
RandomFields plain_fields_of(const Scene& scene, std::uint64_t seed);

/// How each field is made, why, and what that costs in accuracy.
std::string explanation(const Scene& scene, const RandomFields& fields);

}  // namespace slidezone
