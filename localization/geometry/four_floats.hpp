/// Four numbers that are computed at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace castaway::localization {

/// Each operator does to each number what it does to a float, to the bit. A vector type of GCC and
/// Clang, which needs no instructions beyond x86-64 or AArch64.
using FourFloats = float __attribute__((vector_size(4 * sizeof(float))));
using FourInts = int __attribute__((vector_size(4 * sizeof(int))));

/// Coordinates of four points, or components of four vectors.
struct FourPoints {
  FourFloats x, y, z;
};

/// The four numbers from `first` on.
inline FourFloats load_four(const float* first) {
  FourFloats four;
  std::memcpy(&four, first, sizeof four);
  return four;
}

/// As ints, rounded towards zero.
inline FourInts truncate(FourFloats values) { return __builtin_convertvector(values, FourInts); }

/// The first `count` of four numbers from `first` on, then zeros.
inline FourFloats load_some(const float* first, std::size_t count) {
  FourFloats four{};
  std::memcpy(&four, first, std::min(count, std::size_t{4}) * sizeof(float));
  return four;
}

inline FourFloats to_floats(FourInts values) { return __builtin_convertvector(values, FourFloats); }

/// True if one of four masks is.
inline bool any(FourInts mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

/// `value` within 0 and `most`; `most` for NaN.
inline FourFloats clamp(FourFloats value, float most) {
  const FourFloats zero{};
  const FourFloats top = zero + most;
  const FourFloats below = value < top ? value : top;  // Also for NaN.
  return below > zero ? below : zero;
}
inline float clamp(float value, float most) {
  const float below = value < most ? value : most;  // Also for NaN.
  return below > 0.0F ? below : 0.0F;
}

}  // namespace castaway::localization
