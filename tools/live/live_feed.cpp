#include "tools/live/live_feed.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "castaway/stamp.hpp"
#include "sim/world/door.hpp"
#include "sim/world/footprint.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/outputs/records/recording.hpp"
#include "tools/outputs/records/recording_blocks.hpp"
#include "tools/outputs/records/recording_header.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using FeedJson = nlohmann::ordered_json;

constexpr std::size_t kMostBeams = 360;
constexpr std::size_t kMostPoints = 300;  // Particles of a localizer.
constexpr std::size_t kKeptKidnaps = 4;

/// A number of a few digits, so that frames are short; null if it is not finite.
FeedJson rounded(double value, double per_unit = 1e4) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * per_unit) / per_unit;
}

FeedJson pose_json(const SE2& pose) {
  return {rounded(pose.x), rounded(pose.y), rounded(pose.yaw)};
}

FeedJson pose_json(const std::optional<SE2>& pose) { return pose ? pose_json(*pose) : FeedJson(); }

FeedJson truth_json(const ScanRecord& record) {
  FeedJson row = pose_json(T_map_base_of(record.true_pose));
  if (!record.has_heights()) return row;
  for (const double value : lift_of(*record.true_pose->T_footprint_base)) {
    row.push_back(rounded(value));
  }
  return row;
}

FeedJson answer_json(const LocalizerRecord& localizer) {
  FeedJson row = FeedJson::array();
  if (const auto& estimate = localizer.estimate) {
    const Eigen::Matrix3d& covariance = estimate->covariance;
    row = pose_json(estimate->T_map_base);
    row.push_back(estimate->lost ? 1 : 0);
    row.push_back(rounded(estimate->quality, 1e3));
    row.push_back(rounded(estimate->probability, 1e3));
    row.push_back(rounded(std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)))));
    row.push_back(rounded(std::sqrt(covariance(2, 2))));
    if (estimate->footing) row.push_back(rounded(estimate->footing->z));
  }
  std::size_t particles = 0;
  const auto& populations = localizer.diagnostics.populations;
  for (const auto& population : populations) particles += population.particles.size();
  return {{"answer", row.empty() ? FeedJson() : std::move(row)},
          {"populations", populations.size()},
          {"particles", particles}};
}

bool is_torn_by(const std::vector<RunEvent>& kidnaps, const ScanRecord& record) {
  const auto within = [&](Stamp stamp) {
    return stamp > record.stamp && stamp < std::max(record.stamp, record.delivered);
  };
  return std::any_of(kidnaps.begin(), kidnaps.end(), [&](const RunEvent& kidnap) {
    return within(kidnap.stamp) || within(kidnap.begun());
  });
}

/// As if a door had just been turned.
FeedJson door_entry(const sim::Door& door, double open_deg) {
  const sim::WorldObject leaf = sim::door_leaf(door, open_deg);
  sim::WorldNews news{sim::WorldNews::Door{door.name, open_deg}};
  news.outline = sim::footprint(leaf).points;
  news.z = {sim::bounds(leaf).min().z(), sim::bounds(leaf).max().z()};
  return change_entry({}, news);
}

/// Null within 2 mm and 2 mrad of the floor.
FeedJson lift_json(const Eigen::Isometry3d& T_footprint_base) {
  constexpr double kLevel = 2e-3;
  const Eigen::Vector3d lift = lift_of(T_footprint_base);
  if (lift.cwiseAbs().sum() < kLevel) return nullptr;
  return {rounded(lift.x()), rounded(lift.y()), rounded(lift.z())};
}

std::string length_bytes(std::size_t size) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>((size >> (8 * i)) & 0xFFU));
  return bytes;
}

}  // namespace

LiveFeed::LiveFeed(const RunInfo& info, const RosMap& map, double robot_radius_m) {
  const RosMap shown = known_part(map);
  header_ = recording_header(info, shown, robot_radius_m);
  cells_ = pack_cells(shown);
  if (!info.notes.empty()) header_["notes"] = info.notes;
}

void LiveFeed::set_doors(const sim::WorldSpec& world) {
  FeedJson doors = FeedJson::array();
  for (const sim::Door& door : world.doors) {
    doors.push_back(door_entry(door, door.open_deg));
    doors.back()["closed"] = door_entry(door, 0.0)["outline"];
  }
  header_["doors"] = std::move(doors);
}

void LiveFeed::set_levels(const LevelMaps& levels) {
  FeedJson& header = header_["levels"] = levels_header(levels);
  header["cells"] = FeedJson::array();
  for (const LevelMap& level : levels) header["cells"].push_back(base64(pack_cells(level.map)));
}

FeedJson LiveFeed::hello() const {
  FeedJson hello = header_;
  hello["cells"] = base64(cells_);
  return hello;
}

void LiveFeed::add_event(FeedJson event) {
  ++event_count_;
  events_.push_back(std::move(event));
}

void LiveFeed::on_event(const RunEvent& event) {
  const EventNames names = names_of(event.what);
  FeedJson told = {{"time", rounded(localization::seconds(event.stamp))},
                   {"kind", names.kind},
                   {"detail", names.detail},
                   {"localizer", localizer_of(event.what)},
                   {"from", pose_json(event.T_map_from)},
                   {"to", pose_json(event.T_map_to)}};
  const auto* kidnap = event.as<KidnapEvent>();
  if (kidnap != nullptr && kidnap->heights) {
    told["from_z"] = rounded(kidnap->heights->x());
    told["to_z"] = rounded(kidnap->heights->y());
  }
  const auto* news = event.as<sim::WorldNews>();
  if (news != nullptr && !object_of(*news).empty()) {
    told["change"] = change_entry(event.stamp, *news);
  }
  world_news_ = world_news_ || news != nullptr;
  add_event(std::move(told));
  if (kidnap == nullptr) return;
  if (kidnaps_.size() == kKeptKidnaps) kidnaps_.erase(kidnaps_.begin());
  kidnaps_.push_back(event);
}

void LiveFeed::on_drive(Stamp at, const FeedJson& command) {
  add_event({{"time", rounded(localization::seconds(at))},
             {"kind", "drive"},
             {"detail", ""},
             {"localizer", ""},
             {"from", nullptr},
             {"to", nullptr},
             {"drive", command}});
}

void LiveFeed::on_scan(const ScanRecord& record) {
  ++count_;
  FeedJson localizers = FeedJson::array();
  for (const LocalizerRecord& localizer : record.localizers) {
    localizers.push_back(answer_json(localizer));
  }
  scans_.push_back({rounded(localization::seconds(record.stamp)),
                    is_torn_by(kidnaps_, record) ? 1 : 0, truth_json(record),
                    std::move(localizers)});
  set_blocks(record);
}

/// Those of the newest scan are kept.
void LiveFeed::set_blocks(const ScanRecord& record) {
  const std::size_t stride = beam_stride(record.scan.ranges.size(), kMostBeams);
  const std::size_t lidar = recorded_lidar(record.scan, stride, header_);
  blocks_ = {pack_beams(lidar, record.scan, stride), pack_people(record.people.people)};
  for (const LocalizerRecord& localizer : record.localizers) {
    blocks_.push_back(pack_populations(localizer.diagnostics.populations, kMostPoints,
                                       header_.contains("heights")));
  }
}

std::string LiveFeed::take_frame(const LivePoses& poses) {
  FeedJson estimates = FeedJson::array();
  for (const auto& estimate : poses.estimates) estimates.push_back(pose_json(estimate));
  FeedJson sizes = FeedJson::array();
  for (const std::string& block : blocks_) sizes.push_back(block.size());
  FeedJson frame = {{"now", rounded(localization::seconds(poses.now))},
                    {"truth", pose_json(poses.T_map_base_true)},
                    {"estimates", std::move(estimates)},
                    {"first", count_ - scans_.size()},
                    {"scans", std::exchange(scans_, FeedJson::array())},
                    {"lidars", header_["lidars"]},
                    {"blocks", std::move(sizes)}};
  if (FeedJson lift = lift_json(poses.T_footprint_base); !lift.is_null()) {
    frame["lift"] = std::move(lift);
  }
  const std::string text = json_text(frame);
  std::string bytes = length_bytes(text.size()) + text;
  for (const std::string& block : std::exchange(blocks_, {})) bytes += block;
  return bytes;
}

FeedJson LiveFeed::take_scans() {
  blocks_.clear();
  return {{"said", "history"},
          {"first", count_ - scans_.size()},
          {"scans", std::exchange(scans_, FeedJson::array())}};
}

FeedJson LiveFeed::take_events() {
  world_news_ = false;
  return {{"said", "events"},
          {"first", event_count_ - events_.size()},
          {"events", std::exchange(events_, FeedJson::array())}};
}

}  // namespace castaway::testbed
