#include "sampling/mapper.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace slidezone {

Mapping::Mapping(const FieldSpec& spec, const MaterialPoints& points) : parameter_(static_cast<std::size_t>(spec.parameter)) {
  std::vector<double> x, y;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    if (std::ranges::find(spec.soils, static_cast<std::size_t>(points.layer[p])) == spec.soils.end()) continue;
    points_.push_back(p);
    x.push_back(points.x[p]);
    y.push_back(points.y[p]);
  }
  if (spec.interpolation == Interpolation::cell)
    cells_ = containing_cells(spec.model.mesh, x, y);
  else
    neighbours_ = neighbours(spec.model.mesh, x, y);
}

void Mapping::map(std::vector<ParameterValues>& values, std::span<const double> field) const {
  for (std::size_t i = 0; i < cells_.size(); ++i) values[points_[i]][parameter_] = field[cells_[i]];
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    const auto& [cells, weights] = neighbours_[i];
    double value = 0;
    for (std::size_t k = 0; k < cells.size(); ++k) value += weights[k] * field[cells[k]];
    values[points_[i]][parameter_] = value;
  }
}

Mapper::Mapper(const Scene& scene, const MaterialPoints& points) : scene_(scene), points_(points) {
  for (const FieldSpec& spec : scene.fields) mappings_.emplace_back(spec, points);
}

std::size_t Mapper::take(const std::function<std::vector<double>(std::size_t)>& field) {
  values_.assign(points_.x.size(), {});
  for (std::size_t i = 0; i < mappings_.size(); ++i) mappings_[i].map(values_, field(i));
  std::size_t at_limits = 0;
  for (std::size_t p = 0; p < values_.size(); ++p) at_limits += hold_within_limits(values_[p], layer(p));
  return at_limits;
}

void Mapper::fill(std::span<double> values, Parameter parameter) const {
  for (std::size_t p = 0; p < values.size(); ++p) {
    const std::optional<double>& value = values_[p][static_cast<std::size_t>(parameter)];
    values[p] = value ? *value : value_of(varied_soil(layer(p), values_[p]), parameter);
  }
}

std::vector<Parameter> varying_parameters(const Scene& scene) {
  std::set<Parameter> parameters;
  for (const FieldSpec& spec : scene.fields) parameters.insert(spec.parameter);
  return {parameters.begin(), parameters.end()};
}

}  // namespace slidezone
