#include "tools/trials/distinguishability.hpp"

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
  const SE2 T_map_base_unkidnapped = T_unkidnapped_map_ * T_map_base_true;
  sum_ += new_share * (evidence_.evaluate(points, T_map_base_true).log_likelihood -
                       evidence_.evaluate(points, T_map_base_unkidnapped).log_likelihood);
  T_map_base_previous_ = T_map_base_true;
  if (!since_ && sum_ >= config_.enough) since_ = stamp;
}

}  // namespace castaway::testbed
