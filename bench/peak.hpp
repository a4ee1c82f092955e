// The most that one core computes: multiplications and additions a second with the vectors of an instruction set, measured with
// twelve chains of x = a x + b that do not wait for each other and never leave the registers.
#pragma once

#include <algorithm>
#include <chrono>

#include "mpm/sweeps.hpp"

namespace slidezone {

template <class Real, int bytes>
[[gnu::always_inline]] inline double run_chains(long rounds, Real a, Real b) {
  constexpr int chains = 12;
  typedef Real Vector __attribute__((vector_size(bytes)));
  const Vector factor = a - Vector{};
  const Vector addend = b - Vector{};
  Vector x[chains];
  for (int k = 0; k < chains; ++k) x[k] = static_cast<Real>(k) - Vector{};  // all different: equal chains would be computed once
  for (long round = 0; round < rounds; ++round)
    for (int k = 0; k < chains; ++k) x[k] = x[k] * factor + addend;
  Vector sum{};
  for (int k = 0; k < chains; ++k) sum += x[k];
  asm volatile("" : : "x"(sum));  // used, as far as the compiler knows
  return 2.0 * chains * static_cast<double>(bytes / sizeof(Real)) * static_cast<double>(rounds);
}

/// Each returns the number of its operations.
template <class Real>
[[gnu::noinline]] double run_chains_baseline(long rounds, Real a, Real b) {
  return run_chains<Real, 16>(rounds, a, b);
}
template <class Real>
[[gnu::noinline, gnu::target("avx2,fma")]] double run_chains_avx2(long rounds, Real a, Real b) {
  return run_chains<Real, 32>(rounds, a, b);
}
template <class Real>
[[gnu::noinline, gnu::target("avx512f")]] double run_chains_avx512(long rounds, Real a, Real b) {
  return run_chains<Real, 64>(rounds, a, b);
}

/// Operations a second: the best of some runs of a millisecond.
template <class Real>
double peak_rate(InstructionSet set) {
  constexpr double (*by_set[])(long, Real, Real) = {run_chains_baseline<Real>, run_chains_avx2<Real>, run_chains_avx512<Real>,
                                                    run_chains_avx512<Real>};
  using Clock = std::chrono::steady_clock;
  double best = 0;
  for (int attempt = 0; attempt < 30; ++attempt) {
    const auto start = Clock::now();
    const double operations = by_set[static_cast<std::size_t>(set)](300000, Real{0.5}, Real{1});
    best = std::max(best, operations / std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best;
}

}  // namespace slidezone
