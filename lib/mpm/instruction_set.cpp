#include "mpm/sweeps.hpp"

namespace slidezone {

Sweeps sweeps_baseline(SoilTraits traits);
Sweeps sweeps_avx2(SoilTraits traits);
Sweeps sweeps_avx512(SoilTraits traits);

InstructionSet best_instruction_set() {
  __builtin_cpu_init();
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
  if (has_avx512) return InstructionSet::avx512;
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  return has_avx2 ? InstructionSet::avx2 : InstructionSet::baseline;
}

Sweeps sweeps(InstructionSet set, SoilTraits traits) {
  switch (set) {
    case InstructionSet::avx512:
      return sweeps_avx512(traits);
    case InstructionSet::avx2:
      return sweeps_avx2(traits);
    case InstructionSet::baseline:
      break;
  }
  return sweeps_baseline(traits);
}

}  // namespace slidezone
