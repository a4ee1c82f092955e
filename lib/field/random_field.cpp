#include "field/random_field.hpp"

#include <cassert>

#include "field/exponential.hpp"
#include "field/lognormal.hpp"

namespace slidezone {

std::size_t fill_sample(std::span<double> values, const FieldModel& model, RandomStream stream) {
  assert(values.size() == model.mesh.size());
  const auto row_size = static_cast<std::size_t>(model.mesh.cells_x);
  fill_normals(values, stream);
  correlate_along_rows(values, row_size, exponential_factor(model.mesh.cell_x, model.horizontal_scale));
  correlate_across_rows(values, row_size, exponential_factor(model.mesh.cell_y, model.vertical_scale));
  make_lognormal(values, lognormal(model.mean, model.cov));
  return raise_to_floor(values, model.floor);
}

}  // namespace slidezone
