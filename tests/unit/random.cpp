// Random streams and the portable elementary functions below them. Seeds are fixed; statistical limits lie four standard
// errors out unless said otherwise, which a good generator misses once in 16,000 seeds.
#include "core/random.hpp"

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "core/portable_math.hpp"
#include "core/provenance.hpp"

namespace slidezone {
namespace {

std::vector<double> normals(std::size_t count, RandomStream stream) {
  std::vector<double> values(count);
  fill_normals(values, stream);
  return values;
}

double correlation(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum / static_cast<double>(a.size());  // mean 0 and variance 1 are known
}

// ---- portable functions: limits are those that the header states ----

TEST(PortableMath, LogIsAccurateAlsoNextToOne) {
  for (double x = 1e-300; x < 1e300; x *= 1.37) EXPECT_NEAR(portable_log(x) / std::log(x), 1, 4e-16) << x;
  for (int i = 1; i < 20000; ++i) EXPECT_NEAR(portable_log(i * 1e-4 + 1e-9) / std::log(i * 1e-4 + 1e-9), 1, 4e-16) << i;
}

TEST(PortableMath, ExpIsAccurateAndClamped) {
  for (int i = -70800; i <= 70900; ++i) {
    EXPECT_NEAR(portable_exp(i * 0.01) / std::exp(i * 0.01), 1, 4e-16) << i;
    EXPECT_NEAR(portable_exp<Fast>(i * 0.01) / std::exp(i * 0.01), 1, 5e-16) << i;
  }
  EXPECT_EQ(portable_exp(0), 1);
  EXPECT_GT(portable_exp(-1e9), 0);
  EXPECT_LT(portable_exp(1e9), std::numeric_limits<double>::infinity());
}

TEST(PortableMath, SineAndCosineAreAccurateToAnEighthOfATurn) {
  for (int i = -785; i <= 785; ++i) {
    EXPECT_NEAR(portable_sine(i * 0.001), std::sin(i * 0.001), 2e-16) << i;
    EXPECT_NEAR(portable_cosine(i * 0.001), std::cos(i * 0.001), 2e-16) << i;
  }
}

TEST(PortableMath, TangentIsAccurateNearlyToAQuarterOfATurn) {
  for (int i = 1; i <= 1500; ++i) EXPECT_NEAR(portable_tangent(i * 0.001) / std::tan(i * 0.001), 1, 4e-15) << i;
  EXPECT_EQ(portable_tangent(0), 0);
}

TEST(PortableMath, FloatsAreAccurateToTheirLastBits) {
  for (int i = -870; i <= 880; ++i) {
    const float x = static_cast<float>(i) * 0.1f;
    EXPECT_NEAR(portable_exp<Portable>(x) / std::exp(static_cast<double>(x)), 1, 1.2e-7) << i;
    EXPECT_NEAR(portable_exp<Fast>(x) / std::exp(static_cast<double>(x)), 1, 1.8e-7) << i;
  }
  EXPECT_EQ(portable_exp<Portable>(0.f), 1);
  EXPECT_EQ(portable_exp<Fast>(0.f), 1);
  EXPECT_GT(portable_exp<Portable>(-1e9f), 0);
  for (int i = 1; i <= 1500; ++i) {
    const float x = static_cast<float>(i) * 0.001f;
    // Next to a quarter of a turn the difference of cosine and sine loses digits, as in double.
    EXPECT_NEAR(portable_tangent(x) / std::tan(static_cast<double>(x)), 1, 2e-6) << i;
  }
  EXPECT_EQ(portable_tangent(0.f), 0);
}

// ---- the scheme ----

/// Numbers 2 block and 2 block + 1 as the header defines them, by the C library.
std::array<double, 2> by_definition(std::uint64_t block, RandomStream stream) {
  const auto w = philox4x32_R(10, {{std::uint32_t(block), std::uint32_t(block >> 32), stream.sample, stream.purpose}},
                              {{std::uint32_t(stream.seed), std::uint32_t(stream.seed >> 32)}});
  const std::uint64_t low = w.v[0] | std::uint64_t{w.v[1]} << 32;
  const std::uint64_t high = w.v[2] | std::uint64_t{w.v[3]} << 32;
  const double u = (static_cast<double>(low >> 12) + 0.5) * 0x1p-52;
  const double f = (static_cast<double>(high << 2 >> 12) + 0.5) * 0x1p-52;
  const double angle = (static_cast<double>(high >> 62) + f - 0.5) * std::numbers::pi / 2;
  const double r = std::sqrt(-2 * std::log(u));
  return {r * std::cos(angle), r * std::sin(angle)};
}

TEST(Random, FollowsItsDefinition) {
  const RandomStream stream{0x123456789abcdef0, 77, 4000000000};
  const std::vector<double> values = normals(2001, stream);
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(values[i], by_definition(i / 2, stream)[i % 2], 1e-14) << i;  // rounding of an angle of up to 2 pi
}

TEST(Random, Random123IsPhilox) {
  const std::uint32_t ones = 0xffffffff;  // known answers published with Random123 (kat_vectors)
  const r123::Philox4x32::ctr_type expected = {{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}};
  EXPECT_EQ(philox4x32_R(10, {{ones, ones, ones, ones}}, {{ones, ones}}), expected);
}

TEST(Random, NumbersNeverChange) {
  // Written down from the first version, equal with AVX-512, AVX2 and plain x86-64: a difference here would renumber every
  // study ever made.
  const std::vector<double> values = normals(1000001, {1, purpose("cohesion"), 1});
  EXPECT_EQ(purpose("cohesion"), 291248289u);
  EXPECT_EQ(values[0], -0x1.9937b2afe69e2p-1);
  EXPECT_EQ(values[1], 0x1.b15e70d7a2a4bp+0);
  EXPECT_EQ(values[2], -0x1.2169618c6a10bp-1);
  EXPECT_EQ(checksum({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)}), "4934a7a2eff0d426");
}

TEST(Random, AnyCountGivesTheSameNumbers) {
  const RandomStream stream{42, 1, 7};
  const std::vector<double> all = normals(1000, stream);
  for (const std::size_t count : {0u, 1u, 2u, 255u, 256u, 257u, 511u, 999u})
    EXPECT_TRUE(std::ranges::equal(normals(count, stream), std::span(all).first(count))) << count;
}

TEST(Random, WordsAreThoseOfTheBlocks) {
  std::vector<std::uint64_t> all(600), some(257);
  fill_words(all, {42, 1, 7});
  fill_words(some, {42, 1, 7});
  EXPECT_TRUE(std::ranges::equal(some, std::span(all).first(257)));
  // The first pair of normals has the radius of word 0.
  const std::vector<double> pair = normals(2, {42, 1, 7});
  const double u = (static_cast<double>(all[0] >> 12) + 0.5) * 0x1p-52;
  EXPECT_NEAR(std::hypot(pair[0], pair[1]), std::sqrt(-2 * std::log(u)), 1e-14);
}

// ---- the distribution ----

constexpr std::size_t many = 1'000'000;

TEST(Random, MomentsAreStandardNormal) {
  const std::vector<double> values = normals(many, {1, 2, 3});
  double sums[5] = {};
  for (const double z : values)
    for (int power = 1; power <= 4; ++power) sums[power] += std::pow(z, power);
  const double n = many;
  EXPECT_NEAR(sums[1] / n, 0, 4 * std::sqrt(1 / n));
  EXPECT_NEAR(sums[2] / n, 1, 4 * std::sqrt(2 / n));
  EXPECT_NEAR(sums[3] / n, 0, 4 * std::sqrt(15 / n));
  EXPECT_NEAR(sums[4] / n, 3, 4 * std::sqrt(96 / n));
}

TEST(Random, PassesKolmogorovAndSmirnov) {
  std::vector<double> values = normals(many, {5, 2, 3});
  std::ranges::sort(values);
  double distance = 0;
  for (std::size_t i = 0; i < many; ++i) {
    const double p = std::erfc(-values[i] / std::numbers::sqrt2) / 2;
    distance = std::max({distance, p - static_cast<double>(i) / many, static_cast<double>(i + 1) / many - p});
  }
  EXPECT_LT(distance * std::sqrt(static_cast<double>(many)), 1.63);  // 1 % limit
}

TEST(Random, TailsHaveTheirShare) {
  const std::vector<double> values = normals(10 * many, {9, 2, 3});
  for (const double limit : {2.0, 3.0, 4.0, 4.8}) {
    const double expected = 10 * many * std::erfc(limit / std::numbers::sqrt2);
    const auto found = std::ranges::count_if(values, [&](double z) { return std::abs(z) > limit; });
    EXPECT_NEAR(static_cast<double>(found), expected, 4 * std::sqrt(expected)) << limit;
  }
}

TEST(Random, NeighboursPairsSamplesAndPurposesAreIndependent) {
  const std::vector<double> values = normals(many, {1, 2, 3});
  const double limit = 4 / std::sqrt(static_cast<double>(many));
  for (const std::size_t lag : {1u, 2u, 50u, 250u, 256u})
    EXPECT_NEAR(correlation(std::span(values).subspan(lag), std::span(values).first(many - lag)), 0, limit) << lag;
  EXPECT_NEAR(correlation(values, normals(many, {1, 2, 4})), 0, limit);
  EXPECT_NEAR(correlation(values, normals(many, {1, 3, 3})), 0, limit);
  EXPECT_NEAR(correlation(values, normals(many, {2, 2, 3})), 0, limit);
  std::vector<double> squares[2];
  for (std::size_t i = 0; i < many; ++i) squares[i % 2].push_back((values[i] * values[i] - 1) / std::numbers::sqrt2);
  EXPECT_NEAR(correlation(squares[0], squares[1]), 0, limit * std::numbers::sqrt2);  // half as many pairs
}

}  // namespace
}  // namespace slidezone
