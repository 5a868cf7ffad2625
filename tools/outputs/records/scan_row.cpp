#include "tools/outputs/records/scan_row.hpp"

#include <algorithm>
#include <cmath>

#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {
namespace {

/// Fills in the classes and hits of the beams, and the share that hides the map.
void label_beams(const HitLegend& legend, const std::vector<int>& labels, ScanRow& row) {
  std::size_t hidden = 0;
  for (const int label : labels) {
    const BeamClass of = legend.class_of(label);
    hidden += hides_map(of) ? 1 : 0;
    row.classes.push_back(static_cast<std::uint8_t>(of));
    row.hits.push_back(legend.id_of(label));
  }
  const auto beams = static_cast<double>(std::max<std::size_t>(labels.size(), 1));
  row.occluded = static_cast<double>(hidden) / beams;
}

}  // namespace

Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation) {
  return {std::atan2(rotation(2, 1), rotation(2, 2)),
          -std::asin(std::clamp(rotation(2, 0), -1.0, 1.0)),
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

std::optional<Eigen::Vector3d> height_roll_pitch(
    const std::optional<Eigen::Isometry3d>& T_footprint_base) {
  if (!T_footprint_base) return std::nullopt;
  const Eigen::Vector3d turn = roll_pitch_yaw(T_footprint_base->linear());
  return Eigen::Vector3d(T_footprint_base->translation().z(), turn.x(), turn.y());
}

bool is_off(const LocalizerRecord& localizer, const ScanRecord& record) {
  if (!localizer.estimate) return true;
  const RecoveryConfig right;
  const SE2& estimate = localizer.estimate->T_map_base;
  return position_error(record, *localizer.estimate) >= right.position_m ||
         localization::yaw_distance(record.true_pose->T_map_base, estimate) >= right.yaw_rad;
}

void ScanLabeller::add(const RunEvent& event) {
  if (event.is<sim::PickUp>()) picked_up_ = event.stamp;
  if (!event.is<KidnapEvent>()) return;
  picked_up_.reset();
  kidnaps_.push_back(event);
}

void ScanLabeller::add_kidnaps(const ScanRecord& record, ScanRow& row) const {
  for (const RunEvent& kidnap : kidnaps_) {
    if (kidnap.stamp <= record.stamp) {
      row.since_kidnap_s = seconds(record.stamp - kidnap.stamp);
      continue;
    }
    row.torn = row.torn || kidnap.begun() < record.delivered;
    row.held = row.held || kidnap.begun() <= record.stamp;
  }
  if (!picked_up_) return;
  row.held = row.held || record.stamp >= *picked_up_;
  row.torn = row.torn || record.stamp < *picked_up_;
}

ScanRow ScanLabeller::row_of(const ScanRecord& record) const {
  ScanRow row;
  row.stamp_s = seconds(record.stamp);
  row.T_map_base = T_map_base_of(record.true_pose);
  row.T_odom_base = record.T_odom_base;
  add_kidnaps(record, row);
  label_beams(context_->legend, record.truth.labels, row);
  if (!record.true_pose) return row;
  row.ambiguity = context_->ambiguity.at(record.true_pose->T_map_base.translation());
  for (const LocalizerRecord& localizer : record.localizers) {
    row.lost.push_back(is_off(localizer, record) ? 1 : 0);
  }
  return row;
}

}  // namespace castaway::testbed
