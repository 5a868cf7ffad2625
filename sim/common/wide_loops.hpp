/// Loops over arrays of floats that use the processor's wide registers.
#pragma once

/// Before a function: it is compiled for AVX2, too, and the program takes that version where the
/// processor has AVX2. Both compute the same bits: each element is computed alone, and neither
/// version fuses products with sums. Not in builds with sanitizers, which start too late for it.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define CASTAWAY_WIDE_LOOPS __attribute__((target_clones("avx2", "default")))
#else
#define CASTAWAY_WIDE_LOOPS
#endif
