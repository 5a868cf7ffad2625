/// Four numbers that are computed at once.
#pragma once

#include <cstring>

namespace castaway::localization {

/// Each operator does to each number what it does to a float, to the bit. A vector type of GCC and
/// Clang, which needs no instructions beyond x86-64 or AArch64.
using FourFloats = float __attribute__((vector_size(4 * sizeof(float))));
using FourInts = int __attribute__((vector_size(4 * sizeof(int))));

/// The four numbers from `first` on.
inline FourFloats load_four(const float* first) {
  FourFloats four;
  std::memcpy(&four, first, sizeof four);
  return four;
}

/// As ints, rounded towards zero.
inline FourInts truncated(FourFloats values) { return __builtin_convertvector(values, FourInts); }

inline FourFloats to_floats(FourInts values) { return __builtin_convertvector(values, FourFloats); }

}  // namespace castaway::localization
