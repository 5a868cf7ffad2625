#include "tools/play/replay/recorded_log.hpp"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "tools/base/output/file_name.hpp"
#include "tools/build/bag/bag_reading.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/build/recorded/truth_frame.hpp"
#include "tools/play/replay/recorded_maps.hpp"
#include "tools/ros/bag_topics.hpp"
#include "tools/scenario/files/bag_folder.hpp"

namespace castaway::testbed {
namespace {

using Scans = CarmenSourceConfig::Scans;

/// Index, among the scans that are used, of the first one from `scan` of the log on.
std::size_t used_scan(Scans used, std::size_t scan) {
  if (used == Scans::kAll) return scan;
  return used == Scans::kEven ? (scan + 1) / 2 : scan / 2;
}

/// How many scans of the log are needed; nothing: all, as a jump may lead anywhere.
std::optional<std::int64_t> needed_scans(const ReplaySession& session) {
  const SplicedPart& part = session.part;
  if (!part.scans || !part.jumps.empty()) return std::nullopt;
  return static_cast<std::int64_t>(used_scan(session.scans_used, part.from_scan) + *part.scans);
}

void set_maps(const ReplaySession& session, const std::optional<RosMap>& own,
              const localization::WheelStance& wheels, RecordedLog& log) {
  RecordedMaps maps = open_maps(session, own, wheels);
  log.map = std::move(maps.planar);
  log.volume = std::move(maps.volume);
  log.levels = std::move(maps.levels);
  log.warnings.insert(log.warnings.end(), log.map.warnings.begin(), log.map.warnings.end());
}

void set_frames(Frames frames, const SE2& T_map_truth, RecordedLog& log) {
  move_truth(frames, T_map_truth);
  log.frames = std::make_shared<const Frames>(std::move(frames));
}

/// What a log of its kind cannot have, or a replay without a 3-D map.
void check_settings(const ReplaySession& session) {
  const bool bag = is_bag(session.log);
  if (bag && session.scans_used != Scans::kAll) {
    throw std::invalid_argument("--use takes CARMEN logs, not bags");
  }
  if (!bag && session.topics.clock_offset != 0.0) {
    throw std::invalid_argument("--clock-offset takes bags: a CARMEN log has one clock");
  }
  if (!bag && !session.map3d.empty()) stated_lidar_height(session.base_height);
  if (session.base_height && session.map3d.empty()) {
    throw std::invalid_argument("--base-height is for 3-D maps: name one by --map3d");
  }
}

RecordedLog open_carmen(const ReplaySession& session) {
  RecordedLog log;
  set_maps(session, std::nullopt, {}, log);
  CarmenSourceConfig config;
  config.lidar_height = session.base_height.value_or(0.0);
  config.selection = session.scans_used;
  config.scans = needed_scans(session);
  CarmenSource source(session.log, config);
  set_frames(all_frames(source), session.T_map_truth, log);
  return log;
}

/// The bag's own map, if it has one.
std::optional<RosMap> map_of(const BagInventory& bag, const BagRecording& recording) {
  if (!recording.map) return std::nullopt;
  RosMap map = *recording.map;
  const auto run = bag.metadata.find("run");
  const bool named = run != bag.metadata.end() && run->second.contains("world");
  map.name = named ? run->second.at("world") : bag.files.front().stem().string();
  return map;
}

RecordedLog open_bag(const ReplaySession& session) {
  const BagInventory bag = take_inventory(session.log, bag_files(session.log));
  BagTopicOptions topics = session.topics;
  topics.in_space = !session.map3d.empty();
  const BagGround ground{topics.in_space, session.base_height};
  BagRecording recording = read_bag(bag, choose_topics(bag, topics), ground);
  RecordedLog log;
  log.warnings = std::move(recording.warnings);
  set_maps(session, map_of(bag, recording), recording.wheels, log);
  if (recording.start) log.start = session.T_map_truth * *recording.start;
  log.lidars = lidars_of(recording.frames);
  set_frames(std::move(recording.frames), session.T_map_truth, log);
  return log;
}

}  // namespace

void check_log(const ReplaySession& session) {
  for (const std::string& file : {session.log, session.map, session.map3d}) {
    if (file.empty() || std::filesystem::exists(file)) continue;
    throw std::runtime_error(file + ": cannot be read; check the path and its permissions");
  }
  check_settings(session);
  if (is_bag(session.log)) (void)bag_files(session.log);
  check_maps(session);
}

RecordedLog open_log(const ReplaySession& session) {
  check_log(session);
  return is_bag(session.log) ? open_bag(session) : open_carmen(session);
}

std::string replay_name(const RecordedLog& log) { return "replay-" + file_name_of(log.map.name); }

RunInfo run_info(const ReplaySession& session, const RecordedLog& log) {
  RunInfo info;
  info.scenario = replay_name(log);
  info.world = log.map.name;
  info.robot = "recorded";
  info.seed = session.seed;
  info.known_start = session.known_start;
  info.localizers = names_of(session.localizers);
  info.heights = !session.map3d.empty();
  return info;
}

std::unique_ptr<SplicedSource> spliced_source(const RecordedLog& log,
                                              const ReplaySession& session) {
  SplicedPart part = session.part;
  part.from_scan = used_scan(session.scans_used, part.from_scan);
  try {
    return std::make_unique<SplicedSource>(log.frames, std::move(part));
  } catch (const std::out_of_range& error) {
    throw std::runtime_error(session.log + ": " + error.what());
  }
}

std::optional<localization::PoseWithCovariance> initial_pose(const ReplaySession& session,
                                                             const RecordedLog& log,
                                                             const SplicedSource& source) {
  if (!session.known_start) return std::nullopt;
  const bool at_begin = session.part.from_scan == 0;
  const std::optional<SE2> start = at_begin && log.start ? log.start : source.start_pose();
  if (!start) {
    throw std::runtime_error(session.log +
                             ": holds no truth at the first scan, so there is no true start; use "
                             "--start unknown");
  }
  return localization::PoseWithCovariance{*start, Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal(),
                                          source.start_height()};
}

}  // namespace castaway::testbed
