// Elementary functions for vector loops (core/vector_loop.hpp): no branches, no calls, and the same bits on every machine,
// which the C library does not promise. Taylor series after argument reduction, so every coefficient explains itself.
//
//   log x = k log 2 + 2 artanh s,    x = 2^k m, sqrt(1/2) <= m < sqrt 2, s = (m - 1)/(m + 1)
//   exp x = 2^k exp r,               r = x - k log 2, |r| <= log(2)/2
//   sin, cos                         for |x| <= pi/4 alone
//   tan                              for |x| < pi/2
//
// Largest errors measured: 4e-16 relative (log, exp), 2e-16 absolute (sin, cos), 4e-15 relative (tan, up to 1.5); tests/unit/random.cpp
// holds them to it. Range: log wants positive, normal, finite numbers; exp is clamped to [exp(-708), exp(709)]. Nothing is checked.
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <utility>

#include "core/vector_loop.hpp"

namespace slidezone {

inline constexpr double half_pi = 0x1.921fb54442d18p0;
inline constexpr double log_two = 0x1.62e42fefa39efp-1;

/// Adding it to a double of less than 2^51 leaves the nearest integer in the lowest bits.
inline constexpr double integer_shift = 0x1.8p52;

/// How sums of products are computed. Portable: a b + c is rounded twice, and the result has the same bits on every processor.
struct Portable {
  static constexpr bool in_halves = false;
  template <class Real>
  SLIDEZONE_INLINE static Real multiply_add(Real a, Real b, Real c) {
    return a * b + c;
  }
};
/// Fast: rounded once where the instruction set can, and polynomials as two chains of which neither waits for the other.
struct Fast {
  static constexpr bool in_halves = true;
#if defined(__FMA__)
  SLIDEZONE_INLINE static double multiply_add(double a, double b, double c) { return __builtin_fma(a, b, c); }
  SLIDEZONE_INLINE static float multiply_add(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
#else
  template <class Real>
  SLIDEZONE_INLINE static Real multiply_add(Real a, Real b, Real c) {
    return a * b + c;
  }
#endif
};

/// A polynomial of an odd degree, odd and even powers apart; the coefficient of the highest power comes first.
template <class Way, class Real, class... Lower>
SLIDEZONE_INLINE Real polynomial_in_halves(Real x, Real odd, Real even, Lower... lower) {
  static_assert(sizeof...(lower) % 2 == 0);
  const Real square = x * x;
  ((odd = Way::multiply_add(odd, square, static_cast<Real>(lower)), std::swap(odd, even)), ...);  // they take turns
  return Way::multiply_add(odd, x, even);
}

/// A polynomial by Horner's rule; the coefficient of the highest power comes first.
template <class Way = Portable, class Real, class... Lower>
SLIDEZONE_INLINE Real polynomial(Real x, Real highest, Lower... lower) {
  if constexpr (Way::in_halves) return polynomial_in_halves<Way>(x, highest, static_cast<Real>(lower)...);
  ((highest = Way::multiply_add(highest, x, static_cast<Real>(lower))), ...);
  return highest;
}

SLIDEZONE_INLINE double portable_log(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto k = static_cast<std::uint64_t>(static_cast<std::int64_t>(bits - std::bit_cast<std::uint64_t>(0x1.6a09e667f3bcdp-1)) >> 52);
  const double m = std::bit_cast<double>(bits - (k << 52));
  const double exponent = std::bit_cast<double>(k + std::bit_cast<std::uint64_t>(integer_shift)) - integer_shift;
  const double s = (m - 1) / (m + 1);
  const double t = s * s;
  const double series = polynomial(t, 1. / 21, 1. / 19, 1. / 17, 1. / 15, 1. / 13, 1. / 11, 1. / 9, 1. / 7, 1. / 5, 1. / 3);
  return exponent * log_two + (2 * s + 2 * s * (t * series));
}

template <class Way = Portable>
SLIDEZONE_INLINE double portable_exp(double x) {
  constexpr double log_two_high = 0x1.62e42fefa38p-1;  // 42 bits: its product with k is exact
  constexpr double log_two_low = 0x1.ef35793c7673p-45;
  x = std::min(std::max(x, -708.), 709.);
  const double shifted = Way::multiply_add(x, 1 / log_two, integer_shift);
  const double k = shifted - integer_shift;
  const double r = Way::multiply_add(k, -log_two_low, Way::multiply_add(k, -log_two_high, x));
  // 1/13! ... 1/0!
  const double series = polynomial<Way>(r, 1. / 6227020800, 1. / 479001600, 1. / 39916800, 1. / 3628800, 1. / 362880, 1. / 40320, 1. / 5040,
                                        1. / 720, 1. / 120, 1. / 24, 1. / 6, 1. / 2, 1, 1);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(series) + (std::bit_cast<std::uint64_t>(shifted) << 52));
}

/// The same with the 24 bits of a float, clamped to [exp(-87), exp(88)].
template <class Way, std::same_as<float> Real>
SLIDEZONE_INLINE Real portable_exp(Real x) {
  constexpr float shift = 0x1.8p23f;
  constexpr float log_two_high = 0x1.62ep-1f;  // 12 bits: its product with k is exact
  constexpr float log_two_low = static_cast<float>(log_two - 0x1.62ep-1);
  x = std::min(std::max(x, -87.f), 88.f);
  const float shifted = Way::multiply_add(x, static_cast<float>(1 / log_two), shift);
  const float k = shifted - shift;
  const float r = Way::multiply_add(k, -log_two_low, Way::multiply_add(k, -log_two_high, x));
  // 1/7! ... 1/0!
  const float series = polynomial<Way>(r, 1.f / 5040, 1.f / 720, 1.f / 120, 1.f / 24, 1.f / 6, 1.f / 2, 1, 1);
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(series) + (std::bit_cast<std::uint32_t>(shifted) << 23));
}

SLIDEZONE_INLINE double portable_sine(double x) {
  const double t = x * x;
  const double series = polynomial(t, -1. / 1307674368000, 1. / 6227020800, -1. / 39916800, 1. / 362880, -1. / 5040, 1. / 120, -1. / 6);
  return x + x * (t * series);
}

SLIDEZONE_INLINE double portable_cosine(double x) {
  const double t = x * x;
  const double series =
      polynomial(t, 1. / 20922789888000, -1. / 87178291200, 1. / 479001600, -1. / 3628800, 1. / 40320, -1. / 720, 1. / 24, -1. / 2);
  return 1 + t * series;
}

template <std::same_as<float> Real>
SLIDEZONE_INLINE Real portable_sine(Real x) {
  const float t = x * x;
  const float series = polynomial(t, 1.f / 362880, -1.f / 5040, 1.f / 120, -1.f / 6);
  return x + x * (t * series);
}

template <std::same_as<float> Real>
SLIDEZONE_INLINE Real portable_cosine(Real x) {
  const float t = x * x;
  const float series = polynomial(t, -1.f / 3628800, 1.f / 40320, -1.f / 720, 1.f / 24, -1.f / 2);
  return 1 + t * series;
}

/// For |x| < pi/2, by tan 2a = 2 sin a cos a / (cos^2 a - sin^2 a).
template <class Real>
SLIDEZONE_INLINE Real tangent_by_half(Real half) {
  const Real sine = portable_sine(half);
  const Real cosine = portable_cosine(half);
  return 2 * sine * cosine / ((cosine - sine) * (cosine + sine));
}
SLIDEZONE_INLINE double portable_tangent(double x) { return tangent_by_half(0.5 * x); }
template <std::same_as<float> Real>
SLIDEZONE_INLINE Real portable_tangent(Real x) {
  return tangent_by_half(0.5f * x);
}

}  // namespace slidezone
