#include "tools/outputs/sinks/recording_sink.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <nlohmann/json.hpp>

#include "castaway/stamp.hpp"
#include "tools/outputs/records/recording_blocks.hpp"
#include "tools/outputs/records/recording_header.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using localization::Estimate;

constexpr double kMostDetails = 6000.0;
constexpr double kMostScans = 60000.0;
constexpr std::array<const char*, 4> kBelief{"/quality", "/probability", "/sigma", "/sigma_yaw"};

std::string of_localizer(std::size_t index) { return std::to_string(index); }

}  // namespace

double detail_period(double duration_s) {
  const double period_s = duration_s / kMostDetails;
  return period_s > 0.1 ? period_s : 0.0;
}

double scan_period(double duration_s) {
  const double period_s = duration_s / kMostScans;
  return period_s > 0.1 ? period_s : 0.0;
}

RecordingSink::RecordingSink(const std::filesystem::path& run_folder, const RunInfo& info,
                             const RosMap& map, const RecordingConfig& config)
    : file_(run_folder / "recording.gz"),
      config_(config),
      header_(recording_header(info, map, config.robot_radius_m)),
      heights_(info.heights),
      fixed_{{"map", pack_cells(map)}} {
  if (heights_ && config.levels) {
    const LevelMaps& levels = *config.levels;
    header_["levels"] = levels_header(levels);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      fixed_.push_back({"level/" + std::to_string(i), pack_cells(levels[i].map)});
    }
  }
  if (!config.scene.empty()) fixed_.push_back({"scene", config.scene});
}

void RecordingSink::on_event(const RunEvent& event) {
  if (event.is<KidnapEvent>()) kidnaps_.push_back(event);
  const auto* news = event.as<sim::WorldNews>();
  if (news != nullptr && !object_of(*news).empty()) {
    header_["changes"].push_back(change_entry(event.stamp, *news));
  }
}

bool RecordingSink::is_torn(const ScanRecord& record) const {
  const auto within = [&](Stamp stamp) {
    return stamp > record.stamp && stamp < std::max(record.stamp, record.delivered);
  };
  return std::any_of(kidnaps_.begin(), kidnaps_.end(), [&](const RunEvent& kidnap) {
    return within(kidnap.stamp) || within(kidnap.begun());
  });
}

/// Returns whether a scan of a lidar is due, and advances its next due time if so.
bool RecordingSink::is_due(const ScanRecord& record, double every_s,
                           std::map<std::string, Stamp>& next) {
  if (every_s <= 0.0) return true;
  const auto [due, first] = next.try_emplace(record.scan.lidar, record.stamp);
  if (record.stamp < due->second) return false;
  due->second += localization::from_seconds(every_s);
  return true;
}

void RecordingSink::add_pose(const std::string& prefix, const SE2& pose) {
  columns_[prefix + "/x"].add(quantize(pose.x, kRecordingPose));
  columns_[prefix + "/y"].add(quantize(pose.y, kRecordingPose));
  columns_[prefix + "/yaw"].add(quantize(pose.yaw, kRecordingPose));
}

void RecordingSink::repeat_pose(const std::string& prefix) {
  for (const char* part : {"/x", "/y", "/yaw"}) columns_[prefix + part].repeat();
}

/// The player takes a negative share for one that is not stated.
static double or_negative(double share) { return std::isnan(share) ? -1.0 : share; }

void RecordingSink::add_belief(const std::string& prefix, const Estimate& estimate) {
  const Eigen::Matrix3d& covariance = estimate.covariance;
  const double sigma = std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)));
  columns_[prefix + "/quality"].add(quantize(or_negative(estimate.quality), kRecordingShare));
  columns_[prefix + "/probability"].add(
      quantize(or_negative(estimate.probability), kRecordingShare));
  columns_[prefix + "/sigma"].add(quantize(sigma, kRecordingPose));
  columns_[prefix + "/sigma_yaw"].add(quantize(std::sqrt(covariance(2, 2)), kRecordingPose));
}

void RecordingSink::add_localizer(std::size_t index, const LocalizerRecord& localizer) {
  const std::string prefix = of_localizer(index);
  const auto& estimate = localizer.estimate;
  columns_[prefix + "/flags"].add((estimate ? 1 : 0) + (estimate && estimate->lost ? 2 : 0));
  if (estimate) {
    add_pose(prefix, estimate->T_map_base);
    add_belief(prefix, *estimate);
  } else {
    repeat_pose(prefix);
    for (const char* part : kBelief) columns_[prefix + part].repeat();
  }
  std::size_t particles = 0;
  const auto& populations = localizer.diagnostics.populations;
  for (const auto& population : populations) particles += population.particles.size();
  columns_[prefix + "/populations"].add(static_cast<std::int64_t>(populations.size()));
  columns_[prefix + "/particles"].add(static_cast<std::int64_t>(particles));
}

/// The truth of a log may be planar: it has no columns then. Scans before the first height, and
/// answers without one, are at 0.
void RecordingSink::add_true_height(const ScanRecord& record) {
  const auto lift = T_footprint_base_of(record.true_pose);
  if (!lift && !columns_.contains("truth/z")) return;
  const Eigen::Vector3d values = lift ? lift_of(*lift) : Eigen::Vector3d::Zero();
  const std::array<const char*, 3> names{"truth/z", "truth/roll", "truth/pitch"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto [column, first] = columns_.try_emplace(names[i]);
    for (std::int64_t scan = 0; first && scan < scans_; ++scan) column->second.add(0);
    column->second.add(quantize(values[static_cast<Eigen::Index>(i)], kRecordingPose));
  }
}

void RecordingSink::add_heights(const ScanRecord& record) {
  add_true_height(record);
  for (std::size_t i = 0; i < record.localizers.size(); ++i) {
    const auto& estimate = record.localizers[i].estimate;
    const double z = estimate && estimate->footing ? estimate->footing->z : 0.0;
    columns_[of_localizer(i) + "/z"].add(quantize(z, kRecordingPose));
  }
}

void RecordingSink::add_block(const std::string& name, const std::string& block) {
  columns_[name + "/sizes"].add(static_cast<std::int64_t>(block.size()));
  blocks_[name] += block;
}

void RecordingSink::add_detail(const ScanRecord& record) {
  const std::size_t stride = beam_stride(record.scan.ranges.size(), config_.most_beams);
  columns_["detail"].add(scans_);
  add_block("beams", pack_beams(recorded_lidar(record.scan, stride, header_), record.scan, stride));
  add_block("people", pack_people(record.people.people));
  for (std::size_t i = 0; i < record.localizers.size(); ++i) {
    add_block(of_localizer(i) + "/points",
              pack_populations(record.localizers[i].diagnostics.populations, config_.most_points,
                               heights_));
  }
}

void RecordingSink::on_scan(const ScanRecord& record) {
  assert(record.localizers.size() == header_["localizers"].size());
  if (!is_due(record, config_.scan_every_s, next_scan_)) return;
  columns_["time"].add(quantize(seconds(record.stamp), kRecordingTime));
  columns_["flags"].add((record.true_pose ? 1 : 0) + (is_torn(record) ? 2 : 0));
  if (record.true_pose) {
    add_pose("truth", record.true_pose->T_map_base);
  } else {
    repeat_pose("truth");
  }
  for (std::size_t i = 0; i < record.localizers.size(); ++i) {
    add_localizer(i, record.localizers[i]);
  }
  if (heights_) add_heights(record);
  if (is_due(record, config_.detail_every_s, next_detail_)) add_detail(record);
  ++scans_;
}

void RecordingSink::finish(Stamp, const RunTiming&) {
  header_["scans"] = scans_;
  std::vector<RecordingSection> sections = fixed_;
  for (const auto& [name, column] : columns_) sections.push_back({name, column.bytes()});
  for (const auto& [name, bytes] : blocks_) sections.push_back({name, bytes});
  file_.write(pack_recording(header_, sections));
  file_.commit();
}

}  // namespace castaway::testbed
