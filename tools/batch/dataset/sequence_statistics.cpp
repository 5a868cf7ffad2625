#include "tools/batch/dataset/sequence_statistics.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kWindow = 2;  // [m] Distance over which the odometry error is measured.

/// Rounds to six decimal places; more digits carry no information.
double round_figure(double value) { return std::round(value * 1e6) / 1e6; }

Json number(const std::optional<double>& value) {
  return value ? Json(round_figure(*value)) : Json();
}

Json mean(double sum, std::int64_t count) {
  return count > 0 ? Json(round_figure(sum / static_cast<double>(count))) : Json();
}

/// Position and yaw error between the movement by odometry and the true one.
std::pair<double, double> error_between(const SE2& odometry, const SE2& truth) {
  return {localization::distance(odometry, truth), localization::yaw_distance(odometry, truth)};
}

std::size_t bin_of(double value, double width, int bins) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(value / width), 0, bins - 1));
}

}  // namespace

void OdometryDrift::add(const OdometryFrame& frame) {
  if (!frame.true_pose) return;
  const Mark here{frame.odometry.T_odom_base, frame.true_pose->T_map_base};
  if (marks_.empty()) {
    marks_.push_back(here);
    last_ = here.T_map_base;
    driven_ = 0.0;
    return;
  }
  driven_ += (here.T_map_base.translation() - last_.translation()).norm();
  last_ = here.T_map_base;
  if (driven_ >= static_cast<double>(marks_.size())) set_mark(here);
}

void OdometryDrift::set_mark(const Mark& mark) {
  const auto error_since = [&](const Mark& since) {
    return error_between(since.T_odom_base.inverse() * mark.T_odom_base,
                         since.T_map_base.inverse() * mark.T_map_base);
  };
  curve_.emplace_back(static_cast<int>(marks_.size()), error_since(marks_.front()).first);
  marks_.push_back(mark);
  if (marks_.size() <= kWindow) return;
  const auto [position, yaw] = error_since(marks_[marks_.size() - 1 - kWindow]);
  error_sum_ += position / kWindow;
  yaw_sum_ += yaw / kWindow;
  ++windows_;
}

std::optional<double> OdometryDrift::per_metre() const {
  return windows_ > 0 ? std::optional<double>(error_sum_ / windows_) : std::nullopt;
}

std::optional<double> OdometryDrift::yaw_per_metre() const {
  return windows_ > 0 ? std::optional<double>(yaw_sum_ / windows_) : std::nullopt;
}

void SequenceStatistics::add(const RunEvent& event) {
  const auto* edge = event.as<sim::FaultEdge>();
  faults_ += edge != nullptr && edge->begins ? 1 : 0;
  collisions_ += event.is<sim::Collision>() ? 1 : 0;
  const auto* kidnap = event.as<KidnapEvent>();
  if (kidnap == nullptr && !event.is<sim::PickUp>()) return;
  held_ = kidnap == nullptr;
  last_.reset();
  drift_.restart();
  if (held_ || !event.T_map_from || !event.T_map_to) return;
  const double far = localization::distance(*event.T_map_from, *event.T_map_to);
  kidnaps_.push_back({{"kind", part_name(kidnap->how)},
                      {"at_s", round_figure(seconds(event.stamp))},
                      {"distance_m", round_figure(far)}});
}

void SequenceStatistics::add(const OdometryFrame& frame) {
  if (held_ || !frame.true_pose) return;
  drift_.add(frame);
  const SE2& here = frame.true_pose->T_map_base;
  if (last_) driven_ += (here.translation() - last_->translation()).norm();
  last_ = here;
}

void SequenceStatistics::add_beams(const ScanRecord& record, const ScanRow& row) {
  for (const std::uint8_t of : row.classes) ++classes_[of];
  for (const float range : record.scan.ranges) {
    if (std::isfinite(range)) ++ranges_[bin_of(range, kRangeBin, kRangeBins)];
  }
  beams_ += static_cast<std::int64_t>(record.scan.ranges.size());
}

void SequenceStatistics::add(const ScanRecord& record, const ScanRow& row) {
  ++scans_;
  add_beams(record, row);
  ++occluded_[bin_of(row.occluded, 1.0 / kOccludedBins, kOccludedBins)];
  occluded_sum_ += row.occluded;
  occluded_max_ = std::max(occluded_max_, row.occluded);
  people_ = std::max(people_, static_cast<int>(record.people.people.size()));
  for (std::size_t i = 0; i < row.lost.size(); ++i) {
    lost_[record.localizers[i].name] += row.lost[i];
  }
  if (row.ambiguity) {
    ambiguity_sum_ += *row.ambiguity;
    ++judged_;
  }
  if (!row.T_map_base) return;
  ++coverage_[{static_cast<int>(std::floor(row.T_map_base->x / kCoverageCell)),
               static_cast<int>(std::floor(row.T_map_base->y / kCoverageCell))}];
}

Json SequenceStatistics::json() const {
  Json classes = Json::object();
  for (int i = 0; i < kBeamClasses; ++i) {
    classes[class_name(static_cast<BeamClass>(i))] = classes_[static_cast<std::size_t>(i)];
  }
  Json lost = Json::object();
  for (const auto& [name, scans] : lost_) lost[name] = mean(static_cast<double>(scans), scans_);
  Json curve = Json::array();
  for (const auto& [metre, error] : drift_.curve()) curve.push_back({metre, round_figure(error)});
  Json coverage = Json::array();
  for (const auto& [cell, scans] : coverage_) coverage.push_back({cell.first, cell.second, scans});
  return {{"duration_s", round_figure(seconds(end_))},
          {"distance_m", round_figure(driven_)},
          {"scans", scans_},
          {"beams", beams_},
          {"people", people_},
          {"collisions", collisions_},
          {"faults", faults_},
          {"kidnaps", kidnaps_},
          {"lost", lost},
          {"difficulty",
           {{"ambiguity", mean(ambiguity_sum_, judged_)},
            {"occluded_mean", mean(occluded_sum_, scans_)},
            {"occluded_max", round_figure(occluded_max_)},
            {"odometry_error_per_m", number(drift_.per_metre())},
            {"odometry_yaw_error_rad_per_m", number(drift_.yaw_per_metre())}}},
          {"statistics",
           {{"ranges", ranges_},
            {"classes", classes},
            {"occluded", occluded_},
            {"odometry_error_m", curve},
            {"coverage", coverage}}}};
}

}  // namespace castaway::testbed
