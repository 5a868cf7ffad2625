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
};

/// Searches around outputs. The matcher must outlive it.
class Rescue {
 public:
  Rescue(const RescueConfig& config, const CascadeMatcher& matcher)
      : config_(config), matcher_(matcher) {}

  /// Returns a nearby place where the scan fits better than at the output; nothing if the output
  /// fits about as well as `usual` [nats], or no better place is found. The place starts with the
  /// output's evidence minus the cost of the slip, so that one scan in a crowd does not move the
  /// output away.
  [[nodiscard]] std::optional<WeighedPlace> find(const CreateContext& context,
                                                 const Hypothesis& output, double usual,
                                                 const ScanPoints& points) const;

 private:
  RescueConfig config_;
  const CascadeMatcher& matcher_;
};

}  // namespace castaway::localization
