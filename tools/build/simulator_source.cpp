#include "tools/build/simulator_source.hpp"

#include <utility>

#include <fmt/format.h>

#include "localization/geometry/random.hpp"
#include "sim/people/bodies/person_visuals.hpp"
#include "tools/base/process/cpu_clock.hpp"

namespace castaway::testbed {
namespace {

/// Start of a frame's measurement: for a scan, the stamp of its first beam.
Stamp begin_stamp(const Frame& frame) {
  const auto* scan = std::get_if<ScanFrame>(&frame.data);
  return scan != nullptr ? scan->scan.stamp : frame.stamp;
}

}  // namespace

sim::SimulationStreams simulation_streams(std::uint64_t seed) {
  using localization::substream;
  return {substream(seed, "lidar"), substream(seed, "odometry"), substream(seed, "events"),
          [seed](const std::string& name) { return substream(seed, name); }};
}

SimulatorSource::SimulatorSource(sim::Simulation simulation, std::vector<sim::LidarConfig> lidars,
                                 Stamp duration)
    : simulation_(std::move(simulation)), converter_(std::move(lidars)), duration_(duration) {}

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
    add_event(sim::Collision{}, simulation_.true_pose());
  }
  if (const auto* kidnap = std::get_if<sim::KidnapRecord>(&frame->data)) note(*kidnap);
  pending_.push_back(converter_.frame(*frame));
}

void SimulatorSource::add_event(EventData what, const sim::Pose2& pose,
                                std::optional<Stamp> since) {
  const SE2 T_map_base = to_se2(pose);
  pending_.push_back({newest_, RunEvent{newest_, std::move(what), T_map_base, T_map_base, since}});
}

void SimulatorSource::finish() {
  over_ = true;
  const std::optional<sim::VoidRecord> found = simulation_.void_record();
  if (found) add_event(VoidEvent{found->reason}, simulation_.true_pose(), found->since);
}

void SimulatorSource::note(const sim::KidnapRecord& kidnap) {
  if (!kidnap.too_near) return;
  warnings_.push_back(fmt::format(
      "kidnap at {:.2f} s: no free place at its min_distance_m or farther; it goes to the "
      "farthest, {:.2f} m away",
      seconds(kidnap.since), (kidnap.T_map_to.position() - kidnap.T_map_from.position()).norm()));
  add_event(WarningEvent{warnings_.back()}, kidnap.T_map_from);
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

std::vector<sim::PersonBody> SimulatorSource::people_bodies() const {
  std::vector<sim::PersonBody> bodies;
  for (const auto& person : simulation_.people()) bodies.push_back(person.first);
  return bodies;
}

void SimulatorSource::set_drive_pose(const std::optional<SE2>& T_map_base) {
  simulation_.set_drive_pose(T_map_base ? std::optional(to_pose2(*T_map_base)) : std::nullopt);
}

void SimulatorSource::set_watched_pose(const std::optional<SE2>& T_map_base, double z) {
  simulation_.set_watched_pose(T_map_base ? std::optional(to_pose2(*T_map_base)) : std::nullopt, z);
}

std::optional<SE2> SimulatorSource::start_pose() const { return to_se2(simulation_.start_pose()); }

std::map<std::string, std::chrono::nanoseconds> SimulatorSource::cpu_by_stage() const {
  return simulation_.cpu_by_stage();
}

std::unique_ptr<SimulatorSource> build_source(const Scenario& scenario,
                                              sim::SimulationConfig config) {
  std::vector<sim::LidarConfig> lidars = config.lidars;
  const Stamp duration = config.duration;
  const bool levels = config.levels != nullptr;
  auto source = std::make_unique<SimulatorSource>(
      sim::Simulation(std::move(config), simulation_streams(scenario.seed), thread_cpu_time),
      std::move(lidars), duration);
  source->begin_at(localization::from_seconds(scenario.start.switch_on_s));
  source->stop_after(scenario.stop_after_m);
  if (levels) source->keep_heights();
  if (scenario.outputs.points_every_s > 0.0) source->keep_clouds();
  return source;
}

}  // namespace castaway::testbed
