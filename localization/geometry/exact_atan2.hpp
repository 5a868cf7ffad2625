/// The angle of a point to the last bit.
#pragma once

#include <cmath>

namespace castaway::localization {

/// The angle of (x, y) in [-pi, pi], rounded to the nearest double [rad], so that each yaw is that
/// of some quaternion. std::atan2 may be off by a bit; one step of Newton's method with the series
/// of sine and cosine, whose arithmetic is the same on every CPU, corrects it.
inline double exact_atan2(double y, double x) {
  const long double angle = std::atan2(y, x);
  long double sine = 0.0L;
  long double cosine = 0.0L;
  long double term = 1.0L;  // angle^n / n!, of the sign in the series.
  for (int n = 0; n < 40; ++n) {
    (n % 2 == 0 ? cosine : sine) += n % 4 < 2 ? term : -term;
    term *= angle / static_cast<long double>(n + 1);
  }
  const long double norm = x * cosine + y * sine;
  return static_cast<double>(norm > 0.0L ? angle + (y * cosine - x * sine) / norm : angle);
}

}  // namespace castaway::localization
