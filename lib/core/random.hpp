// Random numbers without state: each depends on (seed, purpose, sample, index) alone, so any of them can be made anywhere,
// in any order, with or without the others.
//
// Scheme, fixed for ever (a change would renumber every study): numbers 2b and 2b + 1 come from one call of Philox4x32-10
// (Salmon, Moraes, Dror, Shaw 2011; Random123) with counter {b low, b high, sample, purpose} and key {seed low, seed high}.
// Its output words w0..w3 give
//   u     = (top 52 bits of w1 w0 + 1/2) / 2^52                     radius r = sqrt(-2 log u)
//   q     = top 2 bits of w3 w2,  f = (next 52 bits + 1/2) / 2^52   angle  a = (q + f - 1/2) pi/2
//   normals r cos a and r sin a                                     (Box and Muller 1958)
// No |normal| exceeds 8.6, where the Normal distribution has 1e-17.
// The same bits on every machine and with every instruction set: see core/portable_math.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace slidezone {

struct RandomStream {
  std::uint64_t seed = 1;
  std::uint32_t purpose = 0;  // keeps the parameters of one sample independent; see purpose()
  std::uint32_t sample = 1;
};

/// The number of a purpose from its name, e.g. "cohesion": the 32-bit FNV-1a hash.
std::uint32_t purpose(std::string_view name);

/// The words w1 w0, w3 w2 of blocks 0, 1, ... of the stream, 64 evenly distributed bits each: for choices and resampling.
void fill_words(std::span<std::uint64_t> words, RandomStream stream);

/// Standard normal numbers 0, 1, 2, ... of the stream.
void fill_normals(std::span<double> normals, RandomStream stream);

}  // namespace slidezone
