// One realization: from a scene, and the strength of one field sample where there is one, to a finished run and its row.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/design.hpp"
#include "mpm/simulation.hpp"
#include "rows/row.hpp"
#include "scene/scene.hpp"
#include "scene/varied_soil.hpp"

namespace slidezone {

/// The field values of one sample at the scene's material points, as rfmap wrote them.
struct FieldSample {
  std::string scene;         // checksum of the scene whose points these are
  std::string fields_scene;  // and of the one that the fields were drawn from
  std::uint64_t realization = 0;
  std::vector<ParameterValues> values;  // of each point
  std::uint64_t floored = 0;            // values that stand at a limit
  Design design = Design::plain;
  std::uint64_t block = 0;
};

/// Takes sample `realization` out of the image of a points file; `name` is its name in messages. Throws if the file's points
/// are not those of the scene, or if it does not hold that sample.
FieldSample field_sample(std::string_view image, const std::string& name, const MaterialPoints& points, std::uint64_t realization);

/// The model that a scene describes, with the sample's values held within the limits of each point's soil. K0 start: vertical stress by the
/// weight of the points above in the same column, horizontal k0 times that. Throws for a time step beyond the stability limit.
Model model_of(const Scene& scene, const MaterialPoints& points, const std::optional<FieldSample>& sample);

/// The energy balance is judged by these parts of gravity's work: beyond the first the row deserves a warning, beyond the
/// second the run counts as diverged.
inline constexpr double energy_error_warning = 0.02;
inline constexpr double energy_error_failure = 0.05;

/// Whether ground that the scene leaves out goes on behind a wall of this kind.
bool goes_on_behind(Wall wall);

/// Whether a slide with this runout stands at a right wall behind which the ground goes on.
bool is_at_right_wall(const Scene& scene, double runout);

/// The row of a finished run. Distances are nan for a diverged one.
Row row_of(const Scene& scene, const MaterialPoints& points, const std::optional<FieldSample>& sample, const Outcome& outcome);

/// The final state for ParaView and VTK, handed to `take` piece by piece; as a table of points; and the surface as a table. See
/// data-schemas/.
void write_state(const MaterialPoints& initial, const Points& now, const Provenance& provenance,
                 const std::function<void(std::string_view)>& take);
std::string points_table(const MaterialPoints& initial, const Points& now, const Provenance& provenance);
std::string profile_table(const Scene& scene, const MaterialPoints& initial, const Points& now, const Provenance& provenance);

}  // namespace slidezone
