// exp(x) for x <= 0 without a branch or a call, so that loops over material points vectorise.
//
// Method: x = n ln2 + r with |r| <= ln2 / 2 (Cody and Waite 1980), Taylor series of e^r to r^12, scaled by 2^n through the
// exponent bits. Accuracy: relative error below 4e-16 for -700 <= x <= 0; smaller x give exp(-700), about 1e-304.
#pragma once

#include <bit>
#include <cstdint>

namespace slidezone {

constexpr double exp_of_negative(double x) {
  constexpr double log2_e = 1.4426950408889634074;
  constexpr double ln2_high = 6.93145751953125e-1;  // few bits, so that n * ln2_high is exact
  constexpr double ln2_low = 1.42860682030941723212e-6;
  constexpr double round_to_whole = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves a whole number in the low bits
  x = x > -700 ? x : -700;
  const double shifted = x * log2_e + round_to_whole;
  const double n = shifted - round_to_whole;
  const double r = (x - n * ln2_high) - n * ln2_low;
  double e = 1.0 / 479001600;
  e = e * r + 1.0 / 39916800;
  e = e * r + 1.0 / 3628800;
  e = e * r + 1.0 / 362880;
  e = e * r + 1.0 / 40320;
  e = e * r + 1.0 / 5040;
  e = e * r + 1.0 / 720;
  e = e * r + 1.0 / 120;
  e = e * r + 1.0 / 24;
  e = e * r + 1.0 / 6;
  e = e * r + 0.5;
  e = e * r + 1;
  e = e * r + 1;
  const std::int64_t bits = (std::bit_cast<std::int64_t>(shifted) << 52) + (std::int64_t{1023} << 52);
  return e * std::bit_cast<double>(bits);
}

}  // namespace slidezone
