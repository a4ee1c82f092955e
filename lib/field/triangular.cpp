#include "field/triangular.hpp"

#include <algorithm>

#include "core/vector_loop.hpp"

namespace slidezone {

SLIDEZONE_VECTOR_LOOP
static void add_multiple(double* __restrict sum, const double* __restrict term, double factor, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) sum[i] += factor * term[i];
}

SLIDEZONE_VECTOR_LOOP
static void scale(double* values, double factor, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) values[i] *= factor;
}

void multiply_along_rows(std::span<double> values, const LowerTriangle& factor) {
  const std::size_t n = factor.size;
  std::vector<double> row(n);
  for (std::size_t begin = 0; begin < values.size(); begin += n) {
    std::copy_n(&values[begin], n, row.begin());
    std::fill_n(&values[begin], n, 0.0);
    for (std::size_t k = 0; k < n; ++k) add_multiple(&values[begin + k], &factor.entries[factor.column_begin(k)], row[k], n - k);
  }
}

void multiply_across_rows(std::span<double> values, const LowerTriangle& factor) {
  const std::size_t row_size = values.size() / factor.size;
  for (std::size_t i = factor.size; i-- > 0;) {  // from the last row, which no other needs
    double* row = &values[i * row_size];
    scale(row, factor.entry(i, i), row_size);
    for (std::size_t k = 0; k < i; ++k) add_multiple(row, &values[k * row_size], factor.entry(i, k), row_size);
  }
}

}  // namespace slidezone
