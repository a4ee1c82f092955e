// What a run will do, before it does it: what the scene uses, and what is left out because nothing needs it.
#pragma once

#include <string>

#include "core/provenance.hpp"
#include "mpm/simulation.hpp"

namespace slidezone {

/// A table `part use because`, one line a part of the method; `has_sample` says whether strength comes from a field sample.
/// Throws as time_step does.
std::string explanation(const Model& model, bool has_sample, const Provenance& provenance);

}  // namespace slidezone
