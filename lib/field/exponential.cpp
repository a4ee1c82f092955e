#include "field/exponential.hpp"

#include <cmath>

#include "core/vector_loop.hpp"

namespace slidezone {

ExponentialFactor exponential_factor(double spacing, double scale) {
  return {std::exp(-2 * spacing / scale), std::sqrt(-std::expm1(-4 * spacing / scale))};
}

/// Several rows at once: within a row each value waits for the one before it.
template <std::size_t rows>
static void sweep_rows(double* first, std::size_t row_size, ExponentialFactor factor) {
  double last[rows];
  for (std::size_t r = 0; r < rows; ++r) last[r] = first[r * row_size];
  for (std::size_t i = 1; i < row_size; ++i)
    for (std::size_t r = 0; r < rows; ++r)
      first[r * row_size + i] = last[r] = factor.memory * last[r] + factor.innovation * first[r * row_size + i];
}

void correlate_along_rows(std::span<double> values, std::size_t row_size, ExponentialFactor factor) {
  constexpr std::size_t at_once = 8;
  const std::size_t rows = values.size() / row_size;
  std::size_t row = 0;
  for (; row + at_once <= rows; row += at_once) sweep_rows<at_once>(&values[row * row_size], row_size, factor);
  for (; row < rows; ++row) sweep_rows<1>(&values[row * row_size], row_size, factor);
}

SLIDEZONE_VECTOR_LOOP
void correlate_across_rows(std::span<double> values, std::size_t row_size, ExponentialFactor factor) {
  for (std::size_t i = row_size; i < values.size(); i += row_size) {
    double* row = &values[i];
    const double* below = row - row_size;
#pragma GCC ivdep
    for (std::size_t k = 0; k < row_size; ++k) row[k] = factor.memory * below[k] + factor.innovation * row[k];
  }
}

}  // namespace slidezone
