// Which soil lies at a place.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.hpp"

namespace slidezone {

/// Index of the last layer whose top lies above the place; the first has no top of its own.
std::size_t soil_at(const std::vector<Layer>& layers, double x, double y);

}  // namespace slidezone
