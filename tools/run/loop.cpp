#include "tools/run/loop.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/run/cpu_clock.hpp"

namespace castaway::testbed {

Loop::Loop(LoopConfig config, std::vector<NamedLocalizer>& localizers,
           std::vector<std::unique_ptr<RunSink>>& sinks)
    : config_(std::move(config)),
      localizers_(localizers),
      sinks_(sinks),
      costs_(localizers.size()),
      driver_(index_of(config_.drive_by, "drive.by")),
      watched_(index_of(config_.watch, "kidnap.localizer")) {}

/// Nothing for an empty name.
std::optional<std::size_t> Loop::index_of(const std::string& name, const char* key) const {
  if (name.empty()) return std::nullopt;
  const auto found = std::find_if(localizers_.begin(), localizers_.end(),
                                  [&](const auto& named) { return named.name == name; });
  if (found == localizers_.end()) {
    throw std::invalid_argument(std::string(key) + " names no localizer of the run: " + name);
  }
  return static_cast<std::size_t>(found - localizers_.begin());
}

void Loop::run(SensorSource& source) {
  const std::chrono::nanoseconds begin = wall_time();
  for (NamedLocalizer& named : localizers_) named.localizer->initialize(config_.start);
  Stamp end{};
  while (const std::optional<Frame> frame = source.next()) {
    end = frame->stamp;
    take(source, *frame);
  }
  RunTiming timing;
  timing.load_s = config_.load_s;
  timing.wall_s = config_.load_s + localization::seconds(wall_time() - begin);
  for (const auto& [stage, time] : source.cpu_by_stage()) {
    timing.cpu_s[stage] = localization::seconds(time);
  }
  timing.cpu_s["localizers"] = localization::seconds(localizers_cpu_);
  timing.cpu_s["sinks"] = localization::seconds(sinks_cpu_);
  for (auto& sink : sinks_) sink->finish(std::max(end, source.duration()), timing);
}

void Loop::take(SensorSource& source, const Frame& frame) {
  if (const auto* event = std::get_if<RunEvent>(&frame.data)) {
    take(*event);
  } else if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    take(source, *odometry);
  } else {
    take(std::get<ScanFrame>(frame.data), frame.stamp);
  }
}

void Loop::take(const RunEvent& event) {
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    if (!localizers_[i].relocalize_at_kidnap || event.kind != EventKind::kKidnap) continue;
    const std::chrono::nanoseconds begin = thread_cpu_time();
    localizers_[i].localizer->initialize(std::nullopt);
    costs_[i].since_scan += thread_cpu_time() - begin;
  }
  tell_sinks([&](RunSink& sink) { sink.on_event(event); });
}

void Loop::take(SensorSource& source, const OdometryFrame& frame) {
  T_odom_base_.add(frame.odometry.stamp, frame.odometry.T_odom_base);
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    const std::chrono::nanoseconds begin = thread_cpu_time();
    localizers_[i].localizer->on_odometry(frame.odometry);
    costs_[i].since_scan += thread_cpu_time() - begin;
  }
  report(source, frame.odometry);
  tell_sinks([&](RunSink& sink) { sink.on_odometry(frame); });
}

/// An estimate advanced by the odometry since its scan; nothing if odometry does not reach back to
/// it.
std::optional<SE2> Loop::carried_on(const localization::Estimate& estimate,
                                    const Odometry& odometry) const {
  const auto T_odom_scan = T_odom_base_.at(estimate.stamp);
  if (!T_odom_scan) return std::nullopt;
  return estimate.T_map_base * T_odom_scan->inverse() * odometry.T_odom_base;
}

/// Passes estimates to the source: the driving localizer's, and the watched one's unless it is
/// lost.
void Loop::report(SensorSource& source, const Odometry& odometry) const {
  if (driver_) {
    const auto estimate = localizers_[*driver_].localizer->estimate();
    source.set_drive_pose(estimate ? carried_on(*estimate, odometry) : std::nullopt);
  }
  if (watched_) {
    const auto estimate = localizers_[*watched_].localizer->estimate();
    const bool sure = estimate && !estimate->lost;
    source.set_watched_pose(sure ? carried_on(*estimate, odometry) : std::nullopt);
  }
}

void Loop::take(const ScanFrame& frame, Stamp delivered) {
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    const std::chrono::nanoseconds begin = thread_cpu_time();
    localizers_[i].localizer->on_scan(frame.scan);
    costs_[i].since_scan += thread_cpu_time() - begin;
  }
  const ScanRecord record = record_of(frame, delivered);
  tell_sinks([&](RunSink& sink) { sink.on_scan(record); });
}

ScanRecord Loop::record_of(const ScanFrame& frame, Stamp delivered) {
  ScanRecord record;
  record.stamp = frame.scan.stamp;
  record.delivered = delivered;
  record.T_map_base_true = frame.T_map_base_true;
  if (!T_odom_base_.empty()) record.T_odom_base = *T_odom_base_.at(T_odom_base_.newest());
  record.scan = frame.scan;
  record.people = frame.people;
  record.truth = frame.truth;
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    LocalizerRecord localizer;
    localizer.name = localizers_[i].name;
    localizer.estimate = localizers_[i].localizer->estimate();
    if (localizer.estimate && localizer.estimate->stamp != record.stamp) {
      localizer.estimate.reset();  // It belongs to an older scan: this one was dropped.
    }
    localizer.diagnostics = localizers_[i].localizer->diagnostics();
    localizer.update_cpu = costs_[i].since_scan;
    localizer.stage_cpu = localizer.diagnostics.cpu_by_stage;
    for (auto& [stage, time] : localizer.stage_cpu) time -= costs_[i].stages[stage];
    localizers_cpu_ += costs_[i].since_scan;
    costs_[i] = {{}, localizer.diagnostics.cpu_by_stage};
    record.localizers.push_back(std::move(localizer));
  }
  return record;
}

template <typename Body>
void Loop::tell_sinks(Body&& body) {
  const std::chrono::nanoseconds begin = thread_cpu_time();
  for (auto& sink : sinks_) body(*sink);
  sinks_cpu_ += thread_cpu_time() - begin;
}

}  // namespace castaway::testbed
