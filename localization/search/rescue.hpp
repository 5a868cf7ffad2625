/// Rescue: a local search around an output that suddenly fits badly (after wheel slip, or a long
/// time without scans).
#pragma once

#include <optional>

#include "localization/search/create.hpp"

namespace castaway::localization {

/// Conditions and range of a rescue.
struct RescueConfig {
  /// [nats] A rescue starts if the scan at the output is less likely than usual by more than this.
  double drop = 6.0;
  double radius = 1.1;      ///< [m] Half edge of the square that is searched.
  double yaw_radius = 0.6;  ///< [rad]
  int candidates = 10;      ///< Maximum number of candidates that are refined.
  double gain = 3.0;        ///< [nats] Minimum improvement by the place found.
  double cost = 14.0;       ///< [nats] The place starts with the output's weight minus this.
  /// [nats] The same for a place on the way of the last step, where jitter of the time stamps moves
  /// a pose.
  double cost_on_way = 3.0;
  double beside_way = 0.25;  ///< [m] Largest distance from that way, without the step's share.
};

/// True if `T_map_base` lies on the way of a step that passes the pose `centre`: at most twice the
/// step before or behind it, at most `beside` [m] and 0.3 times the step away from that line, and
/// at most twice the step's turn (and 0.1 rad) off.
bool is_on_way(const SE2& centre, const SE2& step, double beside, const SE2& T_map_base);

/// Searches around outputs. The matcher must outlive it.
class Rescue {
 public:
  Rescue(const RescueConfig& config, const CascadeMatcher& matcher)
      : config_(config), matcher_(matcher) {}

  /// Returns a nearby place where the scan fits better than at the output; nothing if the output
  /// fits about as well as `usual` [nats], or no better place is found. The place starts with the
  /// output's evidence minus the cost of the slip, so that one scan in a crowd does not move the
  /// output away. `step` is odometry's step of base since the previous scan.
  [[nodiscard]] std::optional<WeighedPlace> find(const CreateContext& context,
                                                 const Hypothesis& output, double usual,
                                                 const ScanPoints& points, const SE2& step) const;
  /// True if a place is so near that a rescue could have moved the output there.
  [[nodiscard]] bool reaches(const SE2& output, const SE2& place) const;

 private:
  RescueConfig config_;
  const CascadeMatcher& matcher_;
};

}  // namespace castaway::localization
