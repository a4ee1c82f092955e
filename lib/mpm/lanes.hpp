// Two, four or eight numbers side by side: the vector types of the sweeps. A pair is (x, y) of a point or a node; four are two such pairs,
// or one number of four points; eight are two fours, or four pairs. Four doubles are one register of AVX or two of baseline x86-64; the
// compiler's flags choose. Eight must fit one register.
// Included by sweeps.cpp alone.
#pragma once

#include <immintrin.h>

#include <limits>
#include <type_traits>
#include <utility>

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

#if defined(__AVX512F__) && !defined(SLIDEZONE_HALVED_REGISTERS)
#define SLIDEZONE_REGISTER_BYTES 64
#elif defined(__AVX2__)
#define SLIDEZONE_REGISTER_BYTES 32
#else
#define SLIDEZONE_REGISTER_BYTES 16
#endif
constexpr int register_bytes = SLIDEZONE_REGISTER_BYTES;
template <class Real>
constexpr bool eight_fit = 8 * sizeof(Real) <= register_bytes;  // one register

template <class Real, int lane_count>
struct Lanes {
  static constexpr int size = lane_count;
  static constexpr int bytes = lane_count * static_cast<int>(sizeof(Real));
  static constexpr int chunks = bytes > register_bytes ? bytes / register_bytes : 1;
  static constexpr int chunk_bytes = bytes < 16 ? 16 : bytes / chunks;  // a pair of floats fills half a register; the rest is not used
  typedef Real Chunk __attribute__((vector_size(chunk_bytes)));
  typedef Real ChunkInMemory __attribute__((vector_size(chunk_bytes), aligned(sizeof(Real)), may_alias));
  Chunk chunk[chunks];

  [[gnu::always_inline]] static Lanes load(const Real* from) {
    if constexpr (bytes < 16) return {{_mm_castpd_ps(_mm_load_sd(reinterpret_cast<const double*>(from)))}};
    Lanes lanes;
    for (int k = 0; k < chunks; ++k) lanes.chunk[k] = reinterpret_cast<const ChunkInMemory*>(from)[k];
    return lanes;
  }
  [[gnu::always_inline]] void store(Real* to) const {
    if constexpr (bytes < 16) return _mm_store_sd(reinterpret_cast<double*>(to), _mm_castps_pd(chunk[0]));
    for (int k = 0; k < chunks; ++k) reinterpret_cast<ChunkInMemory*>(to)[k] = chunk[k];
  }
};

template <class Real>
using Pair = Lanes<Real, 2>;
template <class Real>
using Four = Lanes<Real, 4>;

template <class Real, int n>
[[gnu::always_inline]] inline Lanes<Real, n> operator*(Lanes<Real, n> a, Lanes<Real, n> b) {
  for (int k = 0; k < Lanes<Real, n>::chunks; ++k) a.chunk[k] *= b.chunk[k];
  return a;
}

template <class Real, int n>
[[gnu::always_inline]] inline Lanes<Real, n> operator*(Real a, Lanes<Real, n> b) {
  for (int k = 0; k < Lanes<Real, n>::chunks; ++k) b.chunk[k] *= a;
  return b;
}

template <class Real, int n>
[[gnu::always_inline]] inline Lanes<Real, n> operator+(Lanes<Real, n> a, Lanes<Real, n> b) {
  for (int k = 0; k < Lanes<Real, n>::chunks; ++k) a.chunk[k] += b.chunk[k];
  return a;
}

template <class Real, int n>
[[gnu::always_inline]] inline Lanes<Real, n> operator-(Lanes<Real, n> a, Lanes<Real, n> b) {
  for (int k = 0; k < Lanes<Real, n>::chunks; ++k) a.chunk[k] -= b.chunk[k];
  return a;
}

#if defined(__FMA__)
[[gnu::always_inline]] inline __m128d multiply_add(__m128d a, __m128d b, __m128d c) { return _mm_fmadd_pd(a, b, c); }
[[gnu::always_inline]] inline __m256d multiply_add(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
[[gnu::always_inline]] inline __m128 multiply_add(__m128 a, __m128 b, __m128 c) { return _mm_fmadd_ps(a, b, c); }
[[gnu::always_inline]] inline __m256 multiply_add(__m256 a, __m256 b, __m256 c) { return _mm256_fmadd_ps(a, b, c); }
#if SLIDEZONE_REGISTER_BYTES == 64
[[gnu::always_inline]] inline __m512d multiply_add(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
#endif
#else
template <class Chunk>
[[gnu::always_inline]] inline Chunk multiply_add(Chunk a, Chunk b, Chunk c) {
  return c + a * b;
}
#endif

/// a b + c lane by lane, rounded once where the instruction set can. The compiler itself is not free to fuse (CMakeLists.txt): it would
/// do so here and not there, and kernels that leave things out would differ in their last bits.
template <class Real, int n>
[[gnu::always_inline]] inline Lanes<Real, n> fused(Lanes<Real, n> a, Lanes<Real, n> b, Lanes<Real, n> c) {
  for (int k = 0; k < Lanes<Real, n>::chunks; ++k) c.chunk[k] = multiply_add(a.chunk[k], b.chunk[k], c.chunk[k]);
  return c;
}

template <class Real, int n>
[[gnu::always_inline]] inline Lanes<Real, n> fused(Real a, Lanes<Real, n> b, Lanes<Real, n> c) {
  Lanes<Real, n> everywhere;
  for (int k = 0; k < Lanes<Real, n>::chunks; ++k) everywhere.chunk[k] = a - typename Lanes<Real, n>::Chunk{};
  return fused(everywhere, b, c);
}

/// The pairs that four numbers are made of.
template <class Real>
[[gnu::always_inline]] inline Pair<Real> low(Four<Real> four) {
  if constexpr (Four<Real>::chunk_bytes == 32)
    return {{__builtin_shufflevector(four.chunk[0], four.chunk[0], 0, 1)}};
  else
    return {{four.chunk[0]}};
}
template <class Real>
[[gnu::always_inline]] inline Pair<Real> high(Four<Real> four) {
  if constexpr (Four<Real>::chunks == 2)
    return {{four.chunk[1]}};
  else if constexpr (Four<Real>::chunk_bytes == 32)
    return {{__builtin_shufflevector(four.chunk[0], four.chunk[0], 2, 3)}};
  else
    return {{__builtin_shufflevector(four.chunk[0], four.chunk[0], 2, 3, 2, 3)}};
}

/// (x, y) of a, then (x, y) of b.
template <class Real>
[[gnu::always_inline]] inline Four<Real> both(Pair<Real> a, Pair<Real> b) {
  if constexpr (Four<Real>::chunks == 2)
    return {{a.chunk[0], b.chunk[0]}};
  else if constexpr (Four<Real>::chunk_bytes == 32)
    return {{__builtin_shufflevector(a.chunk[0], b.chunk[0], 0, 1, 2, 3)}};
  else
    return {{__builtin_shufflevector(a.chunk[0], b.chunk[0], 0, 1, 4, 5)}};
}

/// (a, a, b, b)
template <class Real>
[[gnu::always_inline]] inline Four<Real> two_of_each(Real a, Real b) {
  using Chunk = typename Four<Real>::Chunk;
  if constexpr (Four<Real>::chunks == 2)
    return {{a - Chunk{}, b - Chunk{}}};
  else
    return {{__builtin_shufflevector(a - Chunk{}, b - Chunk{}, 0, 1, 6, 7)}};
}

/// Turns four numbers of each of four points into one number of all four points each, or back.
template <class Real>
[[gnu::always_inline]] inline void transpose(Four<Real> (&rows)[4]) {
  if constexpr (Four<Real>::chunks == 2) {
    const auto turn = [](auto& a, auto& b) __attribute__((always_inline)) {
      const auto low_halves = __builtin_shufflevector(a, b, 0, 2);
      b = __builtin_shufflevector(a, b, 1, 3);
      a = low_halves;
    };
    for (int half = 0; half < 2; ++half) {
      turn(rows[0].chunk[half], rows[1].chunk[half]);
      turn(rows[2].chunk[half], rows[3].chunk[half]);
    }
    for (int k = 0; k < 2; ++k) std::swap(rows[k].chunk[1], rows[k + 2].chunk[0]);
  } else {
    const auto even_01 = __builtin_shufflevector(rows[0].chunk[0], rows[1].chunk[0], 0, 4, 2, 6);
    const auto odd_01 = __builtin_shufflevector(rows[0].chunk[0], rows[1].chunk[0], 1, 5, 3, 7);
    const auto even_23 = __builtin_shufflevector(rows[2].chunk[0], rows[3].chunk[0], 0, 4, 2, 6);
    const auto odd_23 = __builtin_shufflevector(rows[2].chunk[0], rows[3].chunk[0], 1, 5, 3, 7);
    rows[0].chunk[0] = __builtin_shufflevector(even_01, even_23, 0, 1, 4, 5);
    rows[1].chunk[0] = __builtin_shufflevector(odd_01, odd_23, 0, 1, 4, 5);
    rows[2].chunk[0] = __builtin_shufflevector(even_01, even_23, 2, 3, 6, 7);
    rows[3].chunk[0] = __builtin_shufflevector(odd_01, odd_23, 2, 3, 6, 7);
  }
}

#if SLIDEZONE_REGISTER_BYTES >= 32

// ---- eight, where they fit one register ---------------------------------------------------------------------------------

template <class Real>
using Eight = Lanes<Real, 8>;

typedef double TwoFloats __attribute__((may_alias));

/// A pair, four times.
[[gnu::always_inline]] inline Eight<float> four_times(Pair<float> pair) {
  return {{_mm256_castpd_ps(_mm256_broadcastsd_pd(_mm_castps_pd(pair.chunk[0])))}};
}
[[gnu::always_inline]] inline Eight<float> four_times(const float* pair) {
  return {{_mm256_castpd_ps(_mm256_set1_pd(*reinterpret_cast<const TwoFloats*>(pair)))}};
}
/// Eight numbers, the first six replaced by a pair, three times.
[[gnu::always_inline]] inline Eight<float> with_three_times(Eight<float> eight, const float* pair) {
  return {{_mm256_blend_ps(eight.chunk[0], four_times(pair).chunk[0], 0x3f)}};
}
/// Eight numbers, the seventh replaced.
[[gnu::always_inline]] inline Eight<float> with_seventh(Eight<float> eight, float number) {
  return {{_mm256_blend_ps(eight.chunk[0], number - Eight<float>::Chunk{}, 0x40)}};
}

#if SLIDEZONE_REGISTER_BYTES == 64
constexpr __mmask8 all_lanes = 0xff;  // GCC 12 warns of what its own header leaves undefined in forms without a mask (GCC bug 105593)
[[gnu::always_inline]] inline Eight<double> four_times(Pair<double> pair) {
  return {{_mm512_maskz_broadcast_f64x2(all_lanes, pair.chunk[0])}};
}
[[gnu::always_inline]] inline Eight<double> four_times(const double* pair) {
  return {{_mm512_maskz_broadcast_f64x2(all_lanes, _mm_loadu_pd(pair))}};
}
[[gnu::always_inline]] inline Eight<double> with_three_times(Eight<double> eight, const double* pair) {
  return {{_mm512_mask_broadcast_f64x2(eight.chunk[0], 0x3f, _mm_loadu_pd(pair))}};
}
[[gnu::always_inline]] inline Eight<double> with_seventh(Eight<double> eight, double number) {
  return {{_mm512_mask_broadcastsd_pd(eight.chunk[0], 0x40, _mm_set_sd(number))}};
}
#endif

/// Lanes of a, counted from 0, and of b, counted from 8, in this order.
template <int... lane, class Real>
[[gnu::always_inline]] inline Lanes<Real, sizeof...(lane)> chosen(Eight<Real> a, std::type_identity_t<Eight<Real>> b) {
  return {{__builtin_shufflevector(a.chunk[0], b.chunk[0], lane...)}};
}

template <class Real>
[[gnu::always_inline]] inline Four<Real> first_four(Eight<Real> eight) {
  return {{__builtin_shufflevector(eight.chunk[0], eight.chunk[0], 0, 1, 2, 3)}};
}

/// The same number eight times, of which the first four are at hand as well: told nothing of it, the compiler would make them anew, at
/// the port where the processor shuffles.
template <class Real>
[[gnu::always_inline]] inline Eight<Real> eight_times(Real number) {
  auto all = number - typename Eight<Real>::Chunk{};
  asm("" : "+v"(all));
  return {{all}};
}

template <class Real>
[[gnu::always_inline]] inline Four<Real> last_four(Eight<Real> eight) {
  return {{__builtin_shufflevector(eight.chunk[0], eight.chunk[0], 4, 5, 6, 7)}};
}

#if SLIDEZONE_REGISTER_BYTES == 64

[[gnu::always_inline]] inline __m512d rough_inverse_root(__m512d x) { return _mm512_maskz_rsqrt14_pd(all_lanes, x); }
[[gnu::always_inline]] inline __m512 rough_inverse_root(__m512 x) { return _mm512_maskz_rsqrt14_ps(0xffff, x); }
[[gnu::always_inline]] inline __m512 multiply_add(__m512 a, __m512 b, __m512 c) { return _mm512_fmadd_ps(a, b, c); }

template <class Register>
struct RootAndInverse {
  Register root, inverse;
};

/// sqrt(x) and 1 / sqrt(x), to some units in the last place, for x >= 0; at 0 the root is 0 and the inverse is finite. By Goldschmidt's
/// iterations from an estimate of 14 bits: a square root and a quotient would keep one of the processor's two vector units busy for three
/// times as long.
template <class Real, int n>
[[gnu::always_inline]] inline RootAndInverse<Lanes<Real, n>> root_and_inverse(Lanes<Real, n> x) {
  constexpr Real least = std::numeric_limits<Real>::min();
  constexpr Real half = 0.5;
  const auto at_least = x.chunk[0] > least ? x.chunk[0] : least - typename Lanes<Real, n>::Chunk{};
  const auto estimate = rough_inverse_root(at_least);
  auto root = x.chunk[0] * estimate;
  auto half_inverse = estimate * half;
  constexpr int iterations = std::is_same_v<Real, double> ? 2 : 1;
  for (int k = 0; k < iterations; ++k) {
    const auto rest = multiply_add(-root, half_inverse, half - typename Lanes<Real, n>::Chunk{});
    root = multiply_add(root, rest, root);
    half_inverse = multiply_add(half_inverse, rest, half_inverse);
  }
  return {{root}, {half_inverse + half_inverse}};
}

#endif

/// The sums of the pairs of a, then of b.
template <class Real>
[[gnu::always_inline]] inline Four<Real> sums_of_pairs(Eight<Real> a, Eight<Real> b) {
  const auto halves = __builtin_shufflevector(a.chunk[0], b.chunk[0], 0, 1, 2, 3, 8, 9, 10, 11) +
                      __builtin_shufflevector(a.chunk[0], b.chunk[0], 4, 5, 6, 7, 12, 13, 14, 15);
  return {{__builtin_shufflevector(halves, halves, 0, 1, 4, 5) + __builtin_shufflevector(halves, halves, 2, 3, 6, 7)}};
}

#endif

}  // namespace
}  // namespace slidezone
