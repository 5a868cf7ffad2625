#include "localization/amcl/update_trigger.hpp"

#include <cmath>
#include <utility>

namespace castaway::localization {

bool UpdateTrigger::take_turn(const std::string& lidar, const SE2& T_odom_base) {
  awaited_.try_emplace(lidar, true);
  if (!updated_at_ || at_rest_ || has_moved_enough(T_odom_base)) {
    for (auto& [name, awaited] : awaited_) awaited = true;
  }
  return std::exchange(awaited_[lidar], false);
}

bool UpdateTrigger::has_moved_enough(const SE2& T_odom_base) const {
  return std::abs(T_odom_base.x - updated_at_->x) > min_d_ ||
         std::abs(T_odom_base.y - updated_at_->y) > min_d_ ||
         yaw_distance(T_odom_base, *updated_at_) > min_a_;
}

}  // namespace castaway::localization
