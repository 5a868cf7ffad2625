#include "tools/batch/trials/distinguishability.hpp"

#include "localization/matching/refine.hpp"

namespace castaway::testbed {

using localization::SE2;

Distinguishability::Distinguishability(const localization::EvidenceModel& evidence,
                                       const SE2& T_map_from, const SE2& T_map_to,
                                       const DistinguishabilityConfig& config)
    : evidence_(evidence),
      config_(config),
      T_unkidnapped_map_(T_map_from * T_map_to.inverse()),
      T_map_base_previous_(T_map_to),
      rate_(config.rate_hz) {}

void Distinguishability::take(localization::Stamp stamp, const localization::ScanPoints& points,
                              const SE2& T_map_base_true) {
  if (points.empty() || !rate_.take_turn(stamp)) return;
  const double new_share =
      independence(config_.comparison, distance(T_map_base_previous_, T_map_base_true),
                   yaw_distance(T_map_base_previous_, T_map_base_true));
  const SE2 T_map_base_unkidnapped = refined(points, T_unkidnapped_map_ * T_map_base_true);
  T_unkidnapped_map_ = T_map_base_unkidnapped * T_map_base_true.inverse();
  const SE2 T_map_base_kidnapped = refined(points, T_map_base_true);
  sum_ += new_share * (evidence_.evaluate(points, T_map_base_kidnapped).log_likelihood -
                       evidence_.evaluate(points, T_map_base_unkidnapped).log_likelihood);
  T_map_base_previous_ = T_map_base_true;
  if (!since_ && sum_ >= config_.enough) since_ = stamp;
}

SE2 Distinguishability::refined(const localization::ScanPoints& points,
                                const SE2& T_map_base) const {
  constexpr localization::RefineConfig kFine{0.04, 0.02, 3};
  return refine_pose(evidence_.endpoint(), points, T_map_base, std::nullopt, kFine);
}

}  // namespace castaway::testbed
