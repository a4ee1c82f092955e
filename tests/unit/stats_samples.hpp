// Samples that the tests of lib/stats share.
#pragma once

#include <limits>
#include <numeric>
#include <vector>

#include "stats/blocks.hpp"
#include "stats/sample.hpp"

namespace slidezone {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline std::vector<double> one_to(std::size_t count) {
  std::vector<double> values(count);
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

inline Sample exactly(const std::vector<double>& values) {
  Sample sample;
  for (const double value : values) sample.push_back({value, Knowledge::exact});
  return sample;
}

/// Each value of `values` alone, in pairs, ...: blocks of this size.
inline Blocks blocks_of(std::size_t size, const std::vector<double>& values) {
  Blocks blocks;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % size == 0) blocks.emplace_back();
    blocks.back().push_back(values[i]);
  }
  return blocks;
}

/// 25 made-up influence distances; what R 4.2.2 says of them stands beside each test.
inline const std::vector<double> distances_25 = {8.31, 9.72, 10.05, 7.44, 12.9, 11.3, 9.1,  10.8, 9.95, 14.2, 8.85, 10.4, 11.9,
                                                 9.33, 10.1, 13.1,  7.9,  9.6,  10.7, 12.2, 8.6,  9.9,  11.1, 10.3, 16.4};

}  // namespace slidezone
