// How well samples of random fields agree with their models: estimates with intervals beside what theory says.
//
//   mean, cov          of the values, over all cells and samples, limits included; theory by quadrature of the transform
//   correlation        of the Gaussian field behind them, at lags along both axes and both diagonals
//   cross_correlation  of the Gaussian fields of two parameters at a point
//
// Each sample gives one number for each row, its average over all cells or pairs of cells. Samples are independent, so Student's
// interval of their mean holds for many of them; that of cov is the interval of the variance about the theory's mean, carried over.
// Intervals are joint: all of them together hold theory with a probability of 99 % for a right sampler (Bonferroni).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "field/random_fields.hpp"
#include "io/table.hpp"
#include "scene/scene.hpp"

namespace slidezone {

/// The table "slidezone-field-check 1" of samples first ... first + count - 1, at least two, of fields that are neither conditioned nor
/// of a design. `done` is told how many are drawn.
Table field_check(const Scene& scene, RandomFields& fields, std::uint32_t first, std::size_t count,
                  const std::function<void(std::size_t)>& done);

/// "all 18 rows agree" or "2 of 18 rows disagree".
std::string verdict_of(const Table& check);

}  // namespace slidezone
