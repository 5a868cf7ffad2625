#include "tools/sources/simulator_source.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "localization/geometry/random.hpp"
#include "sim/people/bodies/person_visuals.hpp"
#include "tools/metrics/void_run.hpp"
#include "tools/sources/scan_truth.hpp"

namespace castaway::testbed {
namespace {

sim::Cell to_cell(std::int8_t p) {
  if (p >= 65) return sim::Cell::kOccupied;
  return p >= 0 && p < 20 ? sim::Cell::kFree : sim::Cell::kUnknown;
}

std::int8_t to_percent(sim::Cell cell) {
  if (cell == sim::Cell::kOccupied) return 100;
  return cell == sim::Cell::kFree ? std::int8_t{0} : std::int8_t{-1};
}

PeopleTruth people_of(const sim::LidarReading& reading) {
  PeopleTruth truth;
  for (const sim::PersonReading& person : reading.people) {
    truth.people.push_back(
        {person.person, to_se2(person.T_map_person), person.velocity, person.gap});
  }
  const auto hits =
      std::count_if(reading.hit_object.begin(), reading.hit_object.end(), sim::is_person);
  const auto beams = static_cast<double>(std::max<std::size_t>(reading.hit_object.size(), 1));
  truth.beams_on_people = static_cast<double>(hits) / beams;
  return truth;
}

/// Start of a frame's measurement: for a scan, the stamp of its first beam.
Stamp begin_stamp(const Frame& frame) {
  const auto* scan = std::get_if<ScanFrame>(&frame.data);
  return scan != nullptr ? scan->scan.stamp : frame.stamp;
}

const char* reason_of(sim::VoidReason reason) {
  switch (reason) {
    case sim::VoidReason::kContactFromStart:
      return kContactFromStart;
    case sim::VoidReason::kNeverMoved:
      return kNeverMoved;
    default:
      return kStuck;
  }
}

std::string name_of(const sim::FaultRecord& fault) {
  const std::string kind = sim::to_string(fault.kind);
  return fault.lidar.empty() ? kind : kind + " " + fault.lidar;
}

}  // namespace

SE2 to_se2(const sim::Pose2& pose) { return {pose.x, pose.y, pose.yaw}; }

sim::Pose2 to_pose2(const SE2& pose) { return {pose.x, pose.y, pose.yaw}; }

RosMap to_ros_map(const sim::Grid& grid, const std::string& name) {
  RosMap map{name,
             grid.width,
             grid.height,
             grid.resolution,
             grid.origin.x(),
             grid.origin.y(),
             grid.origin_yaw,
             {}};
  map.cells.resize(grid.cells.size());
  std::transform(grid.cells.begin(), grid.cells.end(), map.cells.begin(), to_percent);
  return map;
}

sim::Grid to_sim_grid(const RosMap& map) {
  sim::Grid grid{map.width,      map.height, map.resolution, {map.origin_x, map.origin_y},
                 map.origin_yaw, {}};
  grid.cells.resize(map.cells.size());
  std::transform(map.cells.begin(), map.cells.end(), grid.cells.begin(), to_cell);
  return grid;
}

sim::SimulationStreams simulation_streams(std::uint64_t seed) {
  using localization::substream;
  return {substream(seed, "lidar"), substream(seed, "odometry"), substream(seed, "events"),
          [seed](const std::string& name) { return substream(seed, name); }};
}

SimulatorSource::SimulatorSource(sim::Simulation simulation, std::vector<sim::LidarConfig> lidars,
                                 Stamp duration)
    : simulation_(std::move(simulation)), lidars_(std::move(lidars)), duration_(duration) {}

std::optional<Frame> SimulatorSource::next() {
  std::optional<Frame> frame = next_of_all();
  while (frame && begin_stamp(*frame) < begin_) frame = next_of_all();
  return frame;
}

std::optional<Frame> SimulatorSource::next_of_all() {
  if (pending_.empty()) take_next();
  if (pending_.empty()) return std::nullopt;
  Frame frame = std::move(pending_.front());
  pending_.pop_front();
  return frame;
}

/// Queues the next frame, preceded by its events.
void SimulatorSource::take_next() {
  if (over_) return;
  const std::optional<sim::SimFrame> frame = simulation_.next();
  if (!frame) return finish();
  if (stop_after_ > 0.0 && simulation_.distance_driven() >= stop_after_) {
    duration_ = frame->stamp;
    return finish();
  }
  newest_ = frame->stamp;
  if (simulation_.collisions() != collisions_) {
    collisions_ = simulation_.collisions();
    add_event(EventKind::kCollision, "", simulation_.true_pose());
  }
  if (const auto* kidnap = std::get_if<sim::KidnapRecord>(&frame->data)) note(*kidnap);
  pending_.push_back(convert(*frame));
}

void SimulatorSource::add_event(EventKind kind, const std::string& detail, const sim::Pose2& pose,
                                std::optional<Stamp> since) {
  const SE2 T_map_base = to_se2(pose);
  pending_.push_back({newest_, RunEvent{newest_, kind, detail, T_map_base, T_map_base, since}});
}

void SimulatorSource::finish() {
  over_ = true;
  const std::optional<sim::VoidRecord> found = simulation_.void_record();
  if (found)
    add_event(EventKind::kVoid, reason_of(found->reason), simulation_.true_pose(), found->since);
}

void SimulatorSource::note(const sim::KidnapRecord& kidnap) {
  if (!kidnap.too_near) return;
  warnings_.push_back(fmt::format(
      "kidnap at {:.2f} s: no free place at its min_distance_m or farther; it goes to the "
      "farthest, {:.2f} m away",
      seconds(kidnap.since), (kidnap.T_map_to.position() - kidnap.T_map_from.position()).norm()));
  add_event(EventKind::kWarning, warnings_.back(), kidnap.T_map_from);
}

Frame SimulatorSource::convert(const sim::SimFrame& frame) const {
  if (const auto* kidnap = std::get_if<sim::KidnapRecord>(&frame.data)) {
    return {frame.stamp,
            RunEvent{kidnap->stamp, EventKind::kKidnap, sim::to_string(kidnap->kind),
                     to_se2(kidnap->T_map_from), to_se2(kidnap->T_map_to), kidnap->since}};
  }
  if (const auto* pick_up = std::get_if<sim::PickUpRecord>(&frame.data)) {
    const SE2 T_map_base = to_se2(pick_up->T_map_base);
    return {frame.stamp, RunEvent{pick_up->stamp, EventKind::kPickUp, sim::to_string(pick_up->kind),
                                  T_map_base, T_map_base}};
  }
  if (const auto* odometry = std::get_if<sim::OdometryReading>(&frame.data)) {
    return {frame.stamp, OdometryFrame{{odometry->stamp, to_se2(odometry->T_odom_base)},
                                       to_se2(odometry->T_map_base_true)}};
  }
  if (const auto* driving = std::get_if<sim::DriveRecord>(&frame.data)) {
    const SE2 T_map_base = to_se2(driving->T_map_base);
    return {frame.stamp,
            RunEvent{driving->stamp, EventKind::kDriving, driving->what, T_map_base, T_map_base}};
  }
  if (const auto* hit = std::get_if<sim::PersonHit>(&frame.data)) {
    const SE2 T_map_base = to_se2(hit->T_map_base_true);
    return {frame.stamp, RunEvent{hit->stamp, EventKind::kCollision,
                                  "person " + std::to_string(hit->person), T_map_base, T_map_base}};
  }
  if (const auto* fault = std::get_if<sim::FaultRecord>(&frame.data)) {
    const SE2 T_map_base = to_se2(fault->T_map_base_true);
    return {frame.stamp,
            RunEvent{fault->stamp, fault->begins ? EventKind::kFaultOn : EventKind::kFaultOff,
                     name_of(*fault), T_map_base, T_map_base}};
  }
  return {frame.stamp, convert(std::get<sim::LidarReading>(frame.data))};
}

ScanFrame SimulatorSource::convert(const sim::LidarReading& reading) const {
  const sim::LidarConfig& lidar = lidars_[reading.lidar];
  return {planar_scan(reading, lidar), to_se2(reading.T_map_base_true), people_of(reading),
          scan_truth(reading, lidar, clouds_)};
}

DriveNow SimulatorSource::drive_now(const std::vector<sim::DriveWheel>& wheels) const {
  const sim::Twist2 command = simulation_.last_command();
  const sim::WheelAngles angles = simulation_.wheels();
  DriveNow now{command.v, command.w, {}};
  for (const sim::DriveWheel& wheel : wheels) {
    now.joints.emplace_back(wheel.joint, wheel.p_base_wheel.y() > 0.0 ? angles.left : angles.right);
  }
  return now;
}

std::vector<sim::SceneItem> SimulatorSource::people_items() const {
  std::vector<sim::SceneItem> items;
  int index = 0;
  for (const auto& [body, state] : simulation_.people()) {
    for (sim::SceneItem& item : sim::person_visuals(body, state, index)) {
      items.push_back(std::move(item));
    }
    ++index;
  }
  return items;
}

void SimulatorSource::set_drive_pose(const std::optional<SE2>& T_map_base) {
  simulation_.set_drive_pose(T_map_base ? std::optional(to_pose2(*T_map_base)) : std::nullopt);
}

void SimulatorSource::set_watched_pose(const std::optional<SE2>& T_map_base) {
  simulation_.set_watched_pose(T_map_base ? std::optional(to_pose2(*T_map_base)) : std::nullopt);
}

std::optional<SE2> SimulatorSource::start_pose() const { return to_se2(simulation_.start_pose()); }

std::map<std::string, std::chrono::nanoseconds> SimulatorSource::cpu_by_stage() const {
  return simulation_.cpu_by_stage();
}

}  // namespace castaway::testbed
