// Samples of a random field on a mesh: independent normals, correlated (field/exponential.hpp), given their marginal
// distribution (field/lognormal.hpp), raised to a floor.
//
// A sample depends on its random stream and on the model alone: any of them can be drawn anywhere, with or without others.
#pragma once

#include <cstddef>
#include <span>

#include "core/random.hpp"
#include "field/mesh.hpp"

namespace slidezone {

struct FieldModel {
  FieldMesh mesh;
  double horizontal_scale = 0;  // scale of fluctuation, m
  double vertical_scale = 0;
  double mean = 0;
  double cov = 0;    // coefficient of variation
  double floor = 0;  // lowest value
};

/// Fills `values`, of mesh.size(), with one sample; returns how many values were raised to the floor.
std::size_t fill_sample(std::span<double> values, const FieldModel& model, RandomStream stream);

}  // namespace slidezone
