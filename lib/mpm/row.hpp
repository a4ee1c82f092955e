// A row of four nodes with two components each, (x0, y0, x1, y1, ...): the vector type of the sweeps. Its eight numbers are
// one AVX-512 register, two of AVX2, or four of baseline x86-64; the compiler's flags choose. Included by sweeps.cpp alone.
#pragma once

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

using Row = Lanes<8>;
using MassRow = Lanes<4>;  // one number a node

/// (a, b, a, b, ...)
[[gnu::always_inline]] inline Row pairs(double a, double b) {
  Row row;
  for (auto& chunk : row.chunk)
    for (int lane = 0; lane < Row::chunk_size; lane += 2) {
      chunk[lane] = a;
      chunk[lane + 1] = b;
    }
  return row;
}

struct Pair {
  double x;
  double y;
};

/// Sums over the row's first three nodes; the fourth holds zero by its weight.
[[gnu::always_inline]] inline Pair sum_over_nodes(const Row& row) {
  double lane[8];
  row.store(lane);
  return {lane[0] + lane[2] + lane[4], lane[1] + lane[3] + lane[5]};
}

}  // namespace
}  // namespace slidezone
