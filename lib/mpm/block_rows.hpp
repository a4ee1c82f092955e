// Weights of a row of nodes. Included by sweeps.cpp alone.
#pragma once

#include "mpm/row.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

// Along y a row's weights are N = {1 - s + q, s - 2 q, q} and its slopes {r - 1, 1 - 2 r, r}, each for both components, the
// fourth node zero.
alignas(64) constexpr double value_1[8] = {1, 1, 0, 0, 0, 0, 0, 0};
alignas(64) constexpr double value_s[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
alignas(64) constexpr double value_q[8] = {1, 1, -2, -2, 1, 1, 0, 0};
alignas(64) constexpr double slope_1[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
alignas(64) constexpr double mass_1[4] = {1, 0, 0, 0};
alignas(64) constexpr double mass_s[4] = {-1, 1, 0, 0};
alignas(64) constexpr double mass_q[4] = {1, -2, 1, 0};

[[gnu::always_inline]] inline Row row_values(double s, double q) {
  return fused(q, Row::load(value_q), fused(s, Row::load(value_s), Row::load(value_1)));
}
[[gnu::always_inline]] inline Row row_slopes(double r) { return fused(r, Row::load(value_q), Row::load(slope_1)); }
[[gnu::always_inline]] inline MassRow mass_values(double s, double q) {
  return fused(q, MassRow::load(mass_q), fused(s, MassRow::load(mass_s), MassRow::load(mass_1)));
}

}  // namespace
}  // namespace slidezone
