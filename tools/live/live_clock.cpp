#include "tools/live/live_clock.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

using localization::Stamp;

constexpr double kMostBehind = 0.25;  // [s] Of wall time.

}  // namespace

void LiveClock::restart(Wall wall, Stamp now) {
  wall_ = wall;
  from_ = now;
}

void LiveClock::play(Wall wall, Stamp now) {
  playing_ = true;
  restart(wall, now);
}

void LiveClock::set_speed(double speed, Wall wall, Stamp now) {
  speed_ = speed;
  restart(wall, now);
}

Stamp LiveClock::due(Wall wall, Stamp now) {
  if (!playing_) return now;
  const Stamp target =
      from_ + localization::from_seconds(speed_ * localization::seconds(wall - wall_));
  const Stamp most_behind = localization::from_seconds(speed_ * kMostBehind);
  if (target - now <= most_behind) return target;
  restart(wall, now + most_behind);
  return now + most_behind;
}

LiveClock::Wall LiveClock::until(Stamp stamp, Wall wall) const {
  const double ahead = localization::seconds(stamp - from_) / speed_;
  return std::max(Wall(0), wall_ + localization::from_seconds(ahead) - wall);
}

}  // namespace castaway::testbed
