// Weights of a row of nodes. Included by sweeps.cpp alone.
#pragma once

#include "mpm/row.hpp"

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

// Along y a row's weights are N = {1 - s + q, s - 2 q, q} and its slopes {r - 1, 1 - 2 r, r}, each for both components, the
// fourth node zero.
template <class Real>
alignas(64) constexpr Real value_1[8] = {1, 1, 0, 0, 0, 0, 0, 0};
template <class Real>
alignas(64) constexpr Real value_s[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
template <class Real>
alignas(64) constexpr Real value_q[8] = {1, 1, -2, -2, 1, 1, 0, 0};
template <class Real>
alignas(64) constexpr Real slope_1[8] = {-1, -1, 1, 1, 0, 0, 0, 0};
template <class Real>
alignas(64) constexpr Real mass_1[4] = {1, 0, 0, 0};
template <class Real>
alignas(64) constexpr Real mass_s[4] = {-1, 1, 0, 0};
template <class Real>
alignas(64) constexpr Real mass_q[4] = {1, -2, 1, 0};

template <class Real>
[[gnu::always_inline]] inline Row<Real> row_values(Real s, Real q) {
  using R = Row<Real>;
  return fused(q, R::load(value_q<Real>), fused(s, R::load(value_s<Real>), R::load(value_1<Real>)));
}
template <class Real>
[[gnu::always_inline]] inline Row<Real> row_slopes(Real r) {
  return fused(r, Row<Real>::load(value_q<Real>), Row<Real>::load(slope_1<Real>));
}
template <class Real>
[[gnu::always_inline]] inline MassRow<Real> mass_values(Real s, Real q) {
  using R = MassRow<Real>;
  return fused(q, R::load(mass_q<Real>), fused(s, R::load(mass_s<Real>), R::load(mass_1<Real>)));
}

}  // namespace
}  // namespace slidezone
