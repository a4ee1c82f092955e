// The in-situ stage of a scene: what all its realizations share, computed once.
//
// While soil is elastic its strength has no part in a run. Realizations whose strength alone varies are therefore equal, bit for
// bit, until the first point yields at the lowest strength that the fields can have: the residual cohesion of its soil. A field of anything
// but cohesion makes realizations differ from the first step on (stiffness, weight) or has no lowest strength (friction angles turn the
// cone); then there is no such stage.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/provenance.hpp"
#include "mpm/simulation.hpp"
#include "scene/scene.hpp"

namespace slidezone {

/// The scene's in-situ stage; nothing where realizations share none.
std::optional<ElasticStage> in_situ_stage(const Scene& scene, const MaterialPoints& points);

/// The stage as the bytes of a file; see data-schemas/stage.json. A file may say that there is none.
std::string stage_file(const std::optional<ElasticStage>& stage, const Provenance& provenance);

/// What stage_file wrote; `name` is the file's name in messages. Throws if it is of another scene or of another version of mpmrun.
std::optional<ElasticStage> stage_in(std::string_view image, const std::string& name, const Scene& scene, const MaterialPoints& points);

/// Throws unless `model`, of this scene and a field sample, shares the scene's stage: at every point the soil must be that of the scene,
/// and no weaker than the stage allows. A sample of another scene's fields need not be; `name` is its file's name in messages.
void check_shares_stage(const Model& model, const Scene& scene, const MaterialPoints& points, const std::string& name);

}  // namespace slidezone
