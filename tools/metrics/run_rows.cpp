#include "tools/metrics/run_rows.hpp"

#include <algorithm>
#include <iterator>

namespace castaway::testbed {
namespace {

using localization::distance;

const RunEvent* kidnap_between(const std::vector<RunEvent>& kidnaps, Stamp after, Stamp until) {
  const auto found = std::find_if(kidnaps.begin(), kidnaps.end(), [&](const RunEvent& kidnap) {
    return kidnap.stamp > after && kidnap.stamp <= until;
  });
  return found == kidnaps.end() ? nullptr : &*found;
}

double step(const MetricRow& from, const MetricRow& to, const RunEvent* kidnap) {
  const double by_odometry = distance(from.T_odom_base, to.T_odom_base);
  if (!from.T_map_base_true || !to.T_map_base_true) return by_odometry;
  if (kidnap == nullptr) return distance(*from.T_map_base_true, *to.T_map_base_true);
  if (!kidnap->T_map_from || !kidnap->T_map_to) return by_odometry;
  return distance(*from.T_map_base_true, *kidnap->T_map_from) +
         distance(*kidnap->T_map_to, *to.T_map_base_true);
}

}  // namespace

std::optional<PoseError> pose_error(const MetricRow& row) {
  if (!row.T_map_base_true || !row.T_map_base_estimate) return std::nullopt;
  return PoseError{distance(*row.T_map_base_true, *row.T_map_base_estimate),
                   localization::yaw_distance(*row.T_map_base_true, *row.T_map_base_estimate)};
}

std::vector<RunEvent> kidnaps_of(const std::vector<RunEvent>& events) {
  std::vector<RunEvent> kidnaps;
  std::copy_if(events.begin(), events.end(), std::back_inserter(kidnaps),
               [](const RunEvent& event) { return event.kind == "kidnap"; });
  return kidnaps;
}

std::vector<double> driven_distance(const std::vector<MetricRow>& rows,
                                    const std::vector<RunEvent>& kidnaps) {
  std::vector<double> driven(rows.size(), 0.0);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const RunEvent* kidnap = kidnap_between(kidnaps, rows[i - 1].stamp, rows[i].stamp);
    driven[i] = driven[i - 1] + step(rows[i - 1], rows[i], kidnap);
  }
  return driven;
}

}  // namespace castaway::testbed
