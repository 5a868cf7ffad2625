#include "tools/run/metrics/run_rows.hpp"

#include <algorithm>
#include <iterator>

namespace castaway::testbed {
namespace {

using localization::distance;

/// Distance to a pose; 0 while the robot is carried.
double way(const std::optional<SE2>& from, const SE2& to) {
  return from ? distance(*from, to) : 0.0;
}

/// Distance between two rows. Every kidnap between them ends one piece of the path and begins
/// another; the robot does not drive while it is carried.
double step(const MetricRow& from, const MetricRow& to, const std::vector<RunEvent>& kidnaps) {
  const double by_odometry = distance(from.T_odom_base, to.T_odom_base);
  if (!from.T_map_base_true || !to.T_map_base_true) return by_odometry;
  double driven = 0.0;
  std::optional<SE2> T_map_base = from.T_map_base_true;  // Nothing while the robot is carried.
  for (const RunEvent& kidnap : kidnaps) {
    if (kidnap.stamp <= from.stamp || kidnap.begun() > to.stamp) continue;
    if (!kidnap.T_map_from || !kidnap.T_map_to) return by_odometry;
    if (kidnap.begun() > from.stamp) driven += way(T_map_base, *kidnap.T_map_from);
    T_map_base = kidnap.stamp <= to.stamp ? kidnap.T_map_to : std::nullopt;
  }
  return driven + way(T_map_base, *to.T_map_base_true);
}

}  // namespace

std::optional<PoseError> pose_error(const MetricRow& row) {
  if (!row.T_map_base_true || !row.T_map_base_estimate || row.torn) return std::nullopt;
  const double planar = distance(*row.T_map_base_true, *row.T_map_base_estimate);
  return PoseError{row.above == 0.0 ? planar : std::hypot(planar, row.above),
                   localization::yaw_distance(*row.T_map_base_true, *row.T_map_base_estimate)};
}

std::vector<RunEvent> kidnaps_of(const std::vector<RunEvent>& events) {
  std::vector<RunEvent> kidnaps;
  std::copy_if(events.begin(), events.end(), std::back_inserter(kidnaps),
               [](const RunEvent& event) { return event.is<KidnapEvent>(); });
  return kidnaps;
}

std::vector<RunEvent> breaks_of(const std::vector<RunEvent>& events) {
  std::vector<RunEvent> breaks;
  std::copy_if(events.begin(), events.end(), std::back_inserter(breaks), [](const RunEvent& event) {
    return event.is<KidnapEvent>() || event.is<OperatorEvent>();
  });
  return breaks;
}

std::vector<RunEvent> events_for(const std::string& localizer,
                                 const std::vector<RunEvent>& events) {
  std::vector<RunEvent> own;
  std::copy_if(events.begin(), events.end(), std::back_inserter(own), [&](const RunEvent& event) {
    const auto* order = event.as<OperatorEvent>();
    return order == nullptr || order->localizer == localizer;
  });
  return own;
}

std::vector<MetricRow> mark_torn_rows(std::vector<MetricRow> rows,
                                      const std::vector<RunEvent>& kidnaps) {
  for (MetricRow& row : rows) {
    row.torn = std::any_of(kidnaps.begin(), kidnaps.end(), [&](const RunEvent& kidnap) {
      const auto within = [&](Stamp stamp) { return stamp > row.stamp && stamp < row.answered(); };
      return within(kidnap.stamp) || within(kidnap.begun());
    });
  }
  return rows;
}

std::optional<double> truth_share(const std::vector<MetricRow>& rows) {
  if (rows.empty()) return std::nullopt;
  const auto known = std::count_if(rows.begin(), rows.end(), [](const MetricRow& row) {
    return row.T_map_base_true.has_value();
  });
  return static_cast<double>(known) / static_cast<double>(rows.size());
}

std::vector<double> driven_distance(const std::vector<MetricRow>& rows,
                                    const std::vector<RunEvent>& kidnaps) {
  std::vector<double> driven(rows.size(), 0.0);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    driven[i] = driven[i - 1] + step(rows[i - 1], rows[i], kidnaps);
  }
  return driven;
}

}  // namespace castaway::testbed
