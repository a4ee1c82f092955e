// The tables of a scene file, one reader each. Each checks its own keys and, where it is given more than its table, how
// it fits what was read before. Values in SI units; errors as in io/toml.hpp.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "io/toml.hpp"
#include "scene/scene.hpp"

namespace slidezone {

/// [slope]: height, length and angle of a straight face, or any surface.
Slope read_slope(const TomlTable& table);

/// [grid]. The slope must fit with a cell above it, end on the base or at the right wall, and be level only at whole
/// numbers of point spacings: elsewhere the top row of points would be cut off.
Discretization read_grid(const TomlTable& table, const TomlTable& slope_table, const Slope& slope);

/// [[soil]], from the surface down.
std::vector<Layer> read_layers(const std::vector<TomlTable>& tables);

/// [base] and [walls].
void read_base(const TomlTable& table, Boundaries& boundaries);
void read_walls(const TomlTable& table, Boundaries& boundaries);

Gravity read_gravity(const TomlTable& table);

/// [initial]: the velocity that all soil starts with, m/s.
Vec2 read_initial_velocity(const TomlTable& table);

/// [time]; gravity must be full before the end.
TimeStepping read_time(const TomlTable& table, const Gravity& gravity);

/// [method]: how the material point method is carried out.
Scheme read_method(const TomlTable& table);

/// [nonlocal_softening]; some soil must soften.
NonlocalSoftening read_nonlocal_softening(const TomlTable& table, const std::vector<Layer>& layers);

/// The value whose name, among `names` in the order of the enumeration, is the key's text.
template <class Value>
Value named_or(const TomlTable& table, const std::string& key, const std::vector<std::string>& names, Value absent) {
  if (!table.has(key)) return absent;
  return static_cast<Value>(std::ranges::find(names, table.choice(key, names)) - names.begin());
}

/// One [field.<parameter>]; which soils have it is not its own to say.
FieldSpec read_field(const TomlTable& table, Parameter parameter, const Slope& slope);

/// Whether the values of a field, read from `table`, can be those of its soils: their means above the residual strength, unless that
/// is a field itself; angles below 89 degrees; residual cohesion in soils that soften.
void check_values(const TomlTable& table, const FieldSpec& spec, const std::vector<Layer>& layers, bool has_residual_field);

struct Fields {
  std::vector<FieldSpec> specs;
  std::vector<CrossCorrelation> cross_correlations;
};

/// [field.<parameter>] and [soil.field.<parameter>], every one of them. Means must exceed the residual strength, which is the floor
/// of a field, and fields that are correlated must share their mesh and autocorrelation.
Fields read_fields(const TomlTable& file, const Slope& slope, const std::vector<Layer>& layers);

Output read_output(const TomlTable& table);
Study read_study(const TomlTable& table);

/// [site]; without a bearing it is that from crest to toe.
Site read_site(const TomlTable& table);

}  // namespace slidezone
