#include "core/random.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/portable_math.hpp"
#include "core/vector_loop.hpp"

namespace slidezone {

namespace {

constexpr std::size_t batch = 128;  // calls of Philox whose words lie in the first cache at once

/// The output words of `batch` calls: 64 bits for the radius and 64 for the angle of each pair of normals.
struct Words {
  std::uint64_t radius[batch];
  std::uint64_t angle[batch];
};

std::uint64_t joined(std::uint32_t low, std::uint32_t high) { return low | std::uint64_t{high} << 32; }

void draw(Words& words, RandomStream stream, std::uint64_t first, std::size_t count) {
  const r123::Philox4x32::key_type key = {{static_cast<std::uint32_t>(stream.seed), static_cast<std::uint32_t>(stream.seed >> 32)}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t block = first + i;
    const r123::Philox4x32::ctr_type counter = {
        {static_cast<std::uint32_t>(block), static_cast<std::uint32_t>(block >> 32), stream.sample, stream.purpose}};
    const r123::Philox4x32::ctr_type out = philox4x32_R(10, counter, key);
    words.radius[i] = joined(out.v[0], out.v[1]);
    words.angle[i] = joined(out.v[2], out.v[3]);
  }
}

/// (top 52 bits + 1/2) / 2^52 - offset, through a number of [1, 2) that has these bits as its fraction.
SLIDEZONE_INLINE double fraction(std::uint64_t word, double offset) {
  return std::bit_cast<double>(word >> 12 | std::bit_cast<std::uint64_t>(1.)) - (1 + offset - 0x1p-53);
}

SLIDEZONE_INLINE double with_sign(double value, std::uint64_t is_negative) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ is_negative << 63);
}

SLIDEZONE_VECTOR_LOOP
void box_muller(double* __restrict normals, const Words& words, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const double r = std::sqrt(-2 * portable_log(fraction(words.radius[i], 0)));
    const std::uint64_t quadrant = words.angle[i] >> 62;
    const double within = half_pi * fraction(words.angle[i] << 2, 0.5);
    const double c = portable_cosine(within);
    const double s = portable_sine(within);
    const bool is_odd = (quadrant & 1) != 0;
    normals[2 * i] = r * with_sign(is_odd ? s : c, (quadrant ^ quadrant >> 1) & 1);
    normals[2 * i + 1] = r * with_sign(is_odd ? c : s, quadrant >> 1);
  }
}

}  // namespace

std::uint32_t purpose(std::string_view name) {
  std::uint32_t hash = 2166136261;
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619;
  return hash;
}

void fill_words(std::span<std::uint64_t> words, RandomStream stream) {
  Words drawn;
  for (std::size_t first = 0; first < words.size(); first += 2 * batch) {
    const std::size_t count = std::min(2 * batch, words.size() - first);
    draw(drawn, stream, first / 2, (count + 1) / 2);
    for (std::size_t i = 0; i < count; ++i) words[first + i] = i % 2 == 0 ? drawn.radius[i / 2] : drawn.angle[i / 2];
  }
}

void fill_normals(std::span<double> normals, RandomStream stream) {
  Words words;
  const std::size_t pairs = normals.size() / 2;
  for (std::size_t first = 0; first < pairs; first += batch) {
    const std::size_t count = std::min(batch, pairs - first);
    draw(words, stream, first, count);
    box_muller(&normals[2 * first], words, count);
  }
  if (normals.size() % 2 == 0) return;
  double last_pair[2];
  draw(words, stream, pairs, 1);
  box_muller(last_pair, words, 1);
  normals.back() = last_pair[0];
}

}  // namespace slidezone
