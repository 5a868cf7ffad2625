/// Decides which scans cause an update of AMCL: those after enough motion, as in Nav2.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "localization/amcl/amcl_config.hpp"

namespace castaway::localization {

/// Stores the odometry at the last update, and the lidars whose next scan causes one.
class UpdateTrigger {
 public:
  explicit UpdateTrigger(const AmclConfig& config)
      : min_d_(config.update_min_d), min_a_(config.update_min_a), at_rest_(config.update_at_rest) {}

  /// True if a scan of `lidar` at `T_odom_base` is to cause an update. After enough motion this
  /// holds once for every lidar.
  bool take_turn(const std::string& lidar, const SE2& T_odom_base);
  /// Stores the odometry at an update.
  void note_update(const SE2& T_odom_base) { updated_at_ = T_odom_base; }
  /// Forgets the last update, so that the next scan causes one.
  void reset() { updated_at_.reset(); }
  /// Odometry at the last update; nothing before the first one.
  [[nodiscard]] const std::optional<SE2>& updated_at() const { return updated_at_; }

 private:
  [[nodiscard]] bool has_moved_enough(const SE2& T_odom_base) const;

  double min_d_;
  double min_a_;
  bool at_rest_;
  std::optional<SE2> updated_at_;
  std::map<std::string, bool> awaited_;  ///< By lidar: its next scan causes an update.
};

}  // namespace castaway::localization
