/// Rescue: the wide search around an output that suddenly fits badly (wheel slip, a scan much
/// later).
#pragma once

#include <optional>

#include "localization/hypotheses/create.hpp"

namespace castaway::localization {

/// When and where a rescue looks.
struct RescueConfig {
  double drop = 6.0;        ///< [nats] When the output's scan is so much less likely than usual.
  double radius = 1.1;      ///< [m]
  double yaw_radius = 0.6;  ///< [rad]
  int candidates = 10;      ///< Refined at most.
  double gain = 3.0;        ///< [nats] A place found must be so much better.
  double cost = 14.0;       ///< [nats] A place found begins with the output's weight less this.
};

/// Looks around outputs. The matcher outlives it.
class Rescue {
 public:
  Rescue(const RescueConfig& config, const CascadeMatcher& matcher)
      : config_(config), matcher_(matcher) {}

  /// A place near by where the scan fits better than at the output; nothing where the output fits
  /// as well as `usual` (about) or no better place is found. The place begins with the output's
  /// evidence less the cost of the slip, so that one scan in a crowd does not carry the output
  /// away.
  [[nodiscard]] std::optional<WeighedPlace> find(const CreateContext& context,
                                                 const Hypothesis& output, double usual,
                                                 const ScanPoints& points) const;

 private:
  RescueConfig config_;
  const CascadeMatcher& matcher_;
};

}  // namespace castaway::localization
