// Samples of a random field on a mesh: a standard Gaussian field (field/gaussian_field.hpp), conditioned on measurements where
// there are any (field/conditioning.hpp), given its marginal distribution (field/marginal.hpp) and raised to a floor (field/lognormal.hpp).
//
// A sample depends on its random stream and on the model alone: any of them can be drawn anywhere, with or without others.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/random.hpp"
#include "field/conditioning.hpp"
#include "field/gaussian_field.hpp"
#include "field/lognormal.hpp"
#include "field/marginal.hpp"
#include "field/model.hpp"

namespace slidezone {

class RandomField {
 public:
  /// `floor` is the lowest value; measurements are met unless they lie below it.
  RandomField(const FieldModel& model, double floor, std::span<const Measurement> measurements = {})
      : gaussian_(model), marginal_(model.marginal), floor_(floor) {
    if (!measurements.empty()) conditioning_.emplace(model, marginal_, measurements);
  }

  /// Fills `values`, of mesh.size(), with one sample; returns how many values were raised to the floor.
  std::size_t fill_sample(std::span<double> values, RandomStream stream) {
    gaussian_.fill(values, stream);
    if (conditioning_) conditioning_->apply(values, stream);
    marginal_.apply(values);
    return raise_to_floor(values, floor_);
  }

  const MethodReport& report() const { return gaussian_.report(); }

 private:
  GaussianField gaussian_;
  MarginalTransform marginal_;
  std::optional<Conditioning> conditioning_;
  double floor_;
};

}  // namespace slidezone
