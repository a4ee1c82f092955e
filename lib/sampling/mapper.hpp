// Values of random field samples at material points.
//
// A point takes the value of the field's cell that contains it, or one linear between the centres of cells. Values beyond the limits of
// the point's soil are moved to them (scene/varied_soil.hpp). A point whose soil has no field of a parameter has the soil's own value,
// which may follow that of another parameter.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "field/mesh.hpp"
#include "scene/scene.hpp"
#include "scene/varied_soil.hpp"

namespace slidezone {

/// Takes the values of a field at the points whose soils have it.
class Mapping {
 public:
  /// Throws as containing_cells() does.
  Mapping(const FieldSpec& spec, const MaterialPoints& points);

  void map(std::vector<ParameterValues>& values, std::span<const double> field) const;

 private:
  std::size_t parameter_;
  std::vector<std::size_t> points_;
  std::vector<std::size_t> cells_;  // one of the two is empty
  std::vector<Neighbours> neighbours_;
};

/// The values of all parameters at the points, one sample after another. Scene and points must outlive it.
class Mapper {
 public:
  Mapper(const Scene& scene, const MaterialPoints& points);

  /// Takes up a sample, the values of field i of the scene being `field(i)`; returns how many values at points stand at a limit.
  std::size_t take(const std::function<std::vector<double>(std::size_t)>& field);

  /// The values of a parameter.
  void fill(std::span<double> values, Parameter parameter) const;

 private:
  const Layer& layer(std::size_t point) const { return scene_.layers[static_cast<std::size_t>(points_.layer[point])]; }

  const Scene& scene_;
  const MaterialPoints& points_;
  std::vector<Mapping> mappings_;
  std::vector<ParameterValues> values_;
};

/// Which parameters have a field, in the order of Parameter.
std::vector<Parameter> varying_parameters(const Scene& scene);

}  // namespace slidezone
