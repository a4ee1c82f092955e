// Marks a function whose loops are compiled for several instruction sets; the widest that the processor has is chosen when
// the program starts. The source files that use it are compiled with the options VECTOR_LOOP_OPTIONS of CMakeLists.txt:
// without contraction of multiply and add, each operation rounds alike in every version, so all of them give the same bits.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SLIDEZONE_VECTOR_LOOP __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define SLIDEZONE_VECTOR_LOOP
#endif

#define SLIDEZONE_INLINE inline __attribute__((always_inline))  // a version for wide vectors must contain what it calls
