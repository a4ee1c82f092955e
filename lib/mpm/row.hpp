// A row of four nodes with two components each, (x0, y0, x1, y1, ...): the vector type of the sweeps. Its eight numbers are
// one AVX-512 register, two of AVX2, or four of baseline x86-64; the compiler's flags choose. Included by sweeps.cpp alone.
#pragma once

#include <immintrin.h>

namespace slidezone {
namespace {  // compiled once per instruction set: no symbol may be shared between them

#if defined(__AVX512F__)
constexpr int chunk_lanes = 8;
#elif defined(__AVX2__)
constexpr int chunk_lanes = 4;
#else
constexpr int chunk_lanes = 2;
#endif

template <int lane_count>
struct Lanes {
  static constexpr int chunk_size = lane_count < chunk_lanes ? lane_count : chunk_lanes;
  static constexpr int chunks = lane_count / chunk_size;
  typedef double Chunk __attribute__((vector_size(chunk_size * sizeof(double))));
  typedef double ChunkInMemory __attribute__((vector_size(chunk_size * sizeof(double)), aligned(sizeof(double)), may_alias));
  Chunk chunk[chunks];

  [[gnu::always_inline]] static Lanes load(const double* from) {
    Lanes lanes;
    for (int k = 0; k < chunks; ++k) lanes.chunk[k] = reinterpret_cast<const ChunkInMemory*>(from)[k];
    return lanes;
  }
  [[gnu::always_inline]] void store(double* to) const {
    for (int k = 0; k < chunks; ++k) reinterpret_cast<ChunkInMemory*>(to)[k] = chunk[k];
  }
};

template <int n>
[[gnu::always_inline]] inline Lanes<n> operator*(Lanes<n> a, Lanes<n> b) {
  for (int k = 0; k < Lanes<n>::chunks; ++k) a.chunk[k] *= b.chunk[k];
  return a;
}

template <int n>
[[gnu::always_inline]] inline Lanes<n> operator*(double a, Lanes<n> b) {
  for (int k = 0; k < Lanes<n>::chunks; ++k) b.chunk[k] *= a;
  return b;
}

template <int n>
[[gnu::always_inline]] inline Lanes<n> operator+(Lanes<n> a, Lanes<n> b) {
  for (int k = 0; k < Lanes<n>::chunks; ++k) a.chunk[k] += b.chunk[k];
  return a;
}

template <int n>
[[gnu::always_inline]] inline Lanes<n> operator-(Lanes<n> a, Lanes<n> b) {
  for (int k = 0; k < Lanes<n>::chunks; ++k) a.chunk[k] -= b.chunk[k];
  return a;
}

/// a b + c, rounded once where the instruction set can. The compiler itself is not free to fuse (CMakeLists.txt): it would do so
/// here and not there, and kernels that leave things out would differ in their last bits.
template <int n>
[[gnu::always_inline]] inline Lanes<n> fused(double a, Lanes<n> b, Lanes<n> c) {
  for (int k = 0; k < Lanes<n>::chunks; ++k) {
    const typename Lanes<n>::Chunk factor = a - typename Lanes<n>::Chunk{};
#if defined(__AVX512F__)
    if constexpr (Lanes<n>::chunk_size == 8) {
      c.chunk[k] = _mm512_fmadd_pd(factor, b.chunk[k], c.chunk[k]);
      continue;
    }
#endif
#if defined(__FMA__)
    if constexpr (Lanes<n>::chunk_size == 4) {
      c.chunk[k] = _mm256_fmadd_pd(factor, b.chunk[k], c.chunk[k]);
      continue;
    }
#endif
    c.chunk[k] += factor * b.chunk[k];
  }
  return c;
}

using Row = Lanes<8>;
using MassRow = Lanes<4>;  // one number a node
using Pairs = Lanes<4>;    // two pairs

/// (x, y, x, y, ...) of the pair at `from`.
[[gnu::always_inline]] inline Row repeated(const double* from) {
  Row row;
#if defined(__AVX512F__)
  row.chunk[0] = _mm512_maskz_broadcast_f64x2(0xff, _mm_loadu_pd(from));
#elif defined(__AVX2__)
  row.chunk[0] = row.chunk[1] = _mm256_broadcast_pd(reinterpret_cast<const __m128d*>(from));
#else
  row.chunk[0] = row.chunk[1] = row.chunk[2] = row.chunk[3] = _mm_loadu_pd(from);
#endif
  return row;
}

/// Sums of two rows over their four nodes: (x of a, y of a, x of b, y of b).
[[gnu::always_inline]] inline Pairs sums_over_nodes(const Row& a, const Row& b) {
  Pairs sums;
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

}  // namespace
}  // namespace slidezone
