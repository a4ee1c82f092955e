// Products with triangular factors, along and across the rows of a field, in vector loops: the same bits on every machine.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace slidezone {

/// A lower triangular matrix L by columns: column k holds L_kk, L_(k+1)k, ... at column_begin(k).
struct LowerTriangle {
  std::size_t size = 0;
  std::vector<double> entries;

  std::size_t column_begin(std::size_t k) const { return k * size - k * (k - 1) / 2; }
  double entry(std::size_t i, std::size_t k) const { return entries[column_begin(k) + i - k]; }
};

/// Each row of length L.size becomes L times itself.
void multiply_along_rows(std::span<double> values, const LowerTriangle& factor);

/// Each column of length L.size becomes L times itself.
void multiply_across_rows(std::span<double> values, const LowerTriangle& factor);

}  // namespace slidezone
