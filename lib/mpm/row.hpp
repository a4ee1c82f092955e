// A row of four nodes with two components each, (x0, y0, x1, y1, ...): the vector type of the sweeps. Its eight doubles are
// one AVX-512 register, two of AVX2, or four of baseline x86-64, and eight floats half of that; the compiler's flags choose.
// Included by sweeps.cpp alone.
#pragma once

#include <immintrin.h>

#include <type_traits>

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

#if defined(__AVX512F__)
constexpr int register_bytes = 64;
#elif defined(__AVX2__)
constexpr int register_bytes = 32;
#else
constexpr int register_bytes = 16;
#endif

template <class Real, int lane_count>
struct Lanes {
  static constexpr int register_lanes = register_bytes / static_cast<int>(sizeof(Real));
  static constexpr int chunk_size = lane_count < register_lanes ? lane_count : register_lanes;
  static constexpr int chunks = lane_count / chunk_size;
  typedef Real Chunk __attribute__((vector_size(chunk_size * sizeof(Real))));
  typedef Real ChunkInMemory __attribute__((vector_size(chunk_size * sizeof(Real)), aligned(sizeof(Real)), may_alias));
  Chunk chunk[chunks];

  [[gnu::always_inline]] static Lanes load(const Real* from) {
    Lanes lanes;
    for (int k = 0; k < chunks; ++k) lanes.chunk[k] = reinterpret_cast<const ChunkInMemory*>(from)[k];
    return lanes;
  }
  [[gnu::always_inline]] void store(Real* to) const {
    for (int k = 0; k < chunks; ++k) reinterpret_cast<ChunkInMemory*>(to)[k] = chunk[k];
  }
};

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

/// a b + c, rounded once where the instruction set can. The compiler itself is not free to fuse (CMakeLists.txt): it would do so
/// here and not there, and kernels that leave things out would differ in their last bits.
template <class Real, int n>
[[gnu::always_inline]] inline Lanes<Real, n> fused(Real a, Lanes<Real, n> b, Lanes<Real, n> c) {
  for (int k = 0; k < Lanes<Real, n>::chunks; ++k) {
    const typename Lanes<Real, n>::Chunk factor = a - typename Lanes<Real, n>::Chunk{};
    [[maybe_unused]] constexpr int bytes = sizeof(factor);
    [[maybe_unused]] constexpr bool is_double = std::is_same_v<Real, double>;
#if defined(__AVX512F__)
    if constexpr (is_double && bytes == 64) {
      c.chunk[k] = _mm512_fmadd_pd(factor, b.chunk[k], c.chunk[k]);
      continue;
    }
#endif
#if defined(__FMA__)
    if constexpr (is_double && bytes == 32) {
      c.chunk[k] = _mm256_fmadd_pd(factor, b.chunk[k], c.chunk[k]);
      continue;
    }
    if constexpr (!is_double && bytes == 32) {
      c.chunk[k] = _mm256_fmadd_ps(factor, b.chunk[k], c.chunk[k]);
      continue;
    }
    if constexpr (!is_double && bytes == 16) {
      c.chunk[k] = _mm_fmadd_ps(factor, b.chunk[k], c.chunk[k]);
      continue;
    }
#endif
    c.chunk[k] += factor * b.chunk[k];
  }
  return c;
}

template <class Real>
using Row = Lanes<Real, 8>;
template <class Real>
using MassRow = Lanes<Real, 4>;  // one number a node
template <class Real>
using Pairs = Lanes<Real, 4>;  // two pairs

/// (x, y, x, y, ...) of the pair at `from`.
[[gnu::always_inline]] inline Row<double> repeated(const double* from) {
  Row<double> row;
#if defined(__AVX512F__)
  row.chunk[0] = _mm512_maskz_broadcast_f64x2(0xff, _mm_loadu_pd(from));
#elif defined(__AVX2__)
  row.chunk[0] = row.chunk[1] = _mm256_broadcast_pd(reinterpret_cast<const __m128d*>(from));
#else
  row.chunk[0] = row.chunk[1] = row.chunk[2] = row.chunk[3] = _mm_loadu_pd(from);
#endif
  return row;
}

[[gnu::always_inline]] inline Row<float> repeated(const float* from) {
  Row<float> row;
#if defined(__AVX2__)
  row.chunk[0] = _mm256_castpd_ps(_mm256_broadcast_sd(reinterpret_cast<const double*>(from)));
#else
  row.chunk[0] = row.chunk[1] = _mm_castpd_ps(_mm_load1_pd(reinterpret_cast<const double*>(from)));
#endif
  return row;
}

/// Sums of two rows over their four nodes: (x of a, y of a, x of b, y of b).
[[gnu::always_inline]] inline Pairs<double> sums_over_nodes(const Row<double>& a, const Row<double>& b) {
  Pairs<double> sums;
#if defined(__AVX512F__)
  const __m256d half_a = _mm256_add_pd(__builtin_shufflevector(a.chunk[0], a.chunk[0], 0, 1, 2, 3),
                                       __builtin_shufflevector(a.chunk[0], a.chunk[0], 4, 5, 6, 7));
  const __m256d half_b = _mm256_add_pd(__builtin_shufflevector(b.chunk[0], b.chunk[0], 0, 1, 2, 3),
                                       __builtin_shufflevector(b.chunk[0], b.chunk[0], 4, 5, 6, 7));
#elif defined(__AVX2__)
  const __m256d half_a = a.chunk[0] + a.chunk[1];
  const __m256d half_b = b.chunk[0] + b.chunk[1];
#endif
#if defined(__AVX2__)
  sums.chunk[0] = _mm256_permute2f128_pd(half_a, half_b, 0x20) + _mm256_permute2f128_pd(half_a, half_b, 0x31);
#else
  sums.chunk[0] = (a.chunk[0] + a.chunk[2]) + (a.chunk[1] + a.chunk[3]);
  sums.chunk[1] = (b.chunk[0] + b.chunk[2]) + (b.chunk[1] + b.chunk[3]);
#endif
  return sums;
}

[[gnu::always_inline]] inline Pairs<float> sums_over_nodes(const Row<float>& a, const Row<float>& b) {
#if defined(__AVX2__)
  const __m128 half_a = _mm256_castps256_ps128(a.chunk[0]) + _mm256_extractf128_ps(a.chunk[0], 1);
  const __m128 half_b = _mm256_castps256_ps128(b.chunk[0]) + _mm256_extractf128_ps(b.chunk[0], 1);
#else
  const __m128 half_a = a.chunk[0] + a.chunk[1];
  const __m128 half_b = b.chunk[0] + b.chunk[1];
#endif
  return {{_mm_movelh_ps(half_a, half_b) + _mm_movehl_ps(half_b, half_a)}};
}

}  // namespace
}  // namespace slidezone
