#include "sim/navigation/twist_log.hpp"

#include <algorithm>
#include <iterator>

namespace castaway::sim {

Twist2 twist_at(const std::vector<TimedTwist>& log, double t_s) {
  const auto after = std::upper_bound(
      log.begin(), log.end(), t_s, [](double t, const TimedTwist& timed) { return t < timed.t_s; });
  return after == log.begin() ? Twist2{} : std::prev(after)->twist;
}

}  // namespace castaway::sim
