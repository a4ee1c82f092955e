#include "mpm/sweeps.hpp"

namespace slidezone {

Sweeps<double> sweeps_baseline_double(SoilTraits traits);
Sweeps<double> sweeps_avx2_double(SoilTraits traits);
Sweeps<double> sweeps_avx512_double(SoilTraits traits);
Sweeps<double> sweeps_avx512_in_halves_double(SoilTraits traits);
Sweeps<float> sweeps_baseline_float(SoilTraits traits);
Sweeps<float> sweeps_avx2_float(SoilTraits traits);
Sweeps<float> sweeps_avx512_float(SoilTraits traits);

InstructionSet best_instruction_set() {
  __builtin_cpu_init();
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
  const bool is_zen_4 = has_avx512 && __builtin_cpu_is("amdfam19h");  // that family is Zen 3 and Zen 4
  if (has_avx512) return is_zen_4 ? InstructionSet::avx512_in_halves : InstructionSet::avx512;
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  return has_avx2 ? InstructionSet::avx2 : InstructionSet::baseline;
}

template <class Real>
using ForTraits = Sweeps<Real> (*)(SoilTraits);

template <>
Sweeps<double> sweeps(InstructionSet set, SoilTraits traits) {
  constexpr ForTraits<double> by_set[] = {sweeps_baseline_double, sweeps_avx2_double, sweeps_avx512_in_halves_double, sweeps_avx512_double};
  return by_set[static_cast<std::size_t>(set)](traits);
}

template <>
Sweeps<float> sweeps(InstructionSet set, SoilTraits traits) {
  constexpr ForTraits<float> by_set[] = {sweeps_baseline_float, sweeps_avx2_float, sweeps_avx512_float,
                                         sweeps_avx512_float};  // eight floats fill half a register
  return by_set[static_cast<std::size_t>(set)](traits);
}

}  // namespace slidezone
