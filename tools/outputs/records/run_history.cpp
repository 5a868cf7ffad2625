#include "tools/outputs/records/run_history.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace castaway::testbed {

void RunHistory::add(const RunEvent& event) {
  first_stamp = std::min(first_stamp, event.stamp);
  events.push_back(event);
}

void RunHistory::add(const OdometryFrame& frame) {
  first_stamp = std::min(first_stamp, frame.odometry.stamp);
}

void RunHistory::add(const ScanRecord& record) {
  assert(record.localizers.size() == rows.size());
  first_stamp = std::min(first_stamp, record.stamp);
  if (scans++ % stride != 0) return;
  if (rows.empty()) {
    MetricRow row;
    row.stamp = record.stamp;
    row.T_odom_base = record.T_odom_base;
    row.T_map_base_true = T_map_base_of(record.true_pose);
    path.push_back(row);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& estimate = record.localizers[i].estimate;
    MetricRow row;
    row.stamp = record.stamp;
    row.T_odom_base = record.T_odom_base;
    row.T_map_base_true = T_map_base_of(record.true_pose);
    row.delivered = record.delivered;
    if (estimate) {
      row.T_map_base_estimate = estimate->T_map_base;
      row.above = record.height_error(*estimate);
      row.lost = estimate->lost;
      row.probability = estimate->probability;
      row.quality = estimate->quality;
      row.sigma_m = std::sqrt(0.5 * (estimate->covariance(0, 0) + estimate->covariance(1, 1)));
    }
    // Scans of several lidars may be delivered out of the order of their first beams.
    const auto after =
        std::upper_bound(rows[i].begin(), rows[i].end(), row.stamp,
                         [](Stamp stamp, const MetricRow& other) { return stamp < other.stamp; });
    rows[i].insert(after, row);
  }
  thin(most_rows);
}

void RunHistory::thin(std::size_t most) {
  const auto halve = [](std::vector<MetricRow>& all) {
    for (std::size_t i = 0; 2 * i < all.size(); ++i) all[i] = all[2 * i];
    all.resize((all.size() + 1) / 2);
  };
  if ((rows.empty() ? path : rows.front()).size() <= most) return;
  for (auto& localizer : rows) halve(localizer);
  halve(path);
  stride *= 2;
}

}  // namespace castaway::testbed
