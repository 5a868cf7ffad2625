#include "localization/geometry/rate.hpp"

namespace castaway::localization {

bool Rate::take_turn(Stamp now) {
  constexpr double kTolerance = 0.9;
  if (last_ && seconds(now - *last_) < kTolerance / hz_) return false;
  last_ = now;
  return true;
}

}  // namespace castaway::localization
