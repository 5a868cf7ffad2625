#include "tools/run/loop.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "tools/base/process/cpu_clock.hpp"

namespace castaway::testbed {

std::string describe(const LostLocalizer& lost) {
  return "localizer '" + lost.name + "' " + lost.what;
}

void require_none(const std::vector<LostLocalizer>& lost) {
  if (!lost.empty()) throw LocalizerFailure(describe(lost.front()));
}

Loop::Loop(LoopConfig config, std::vector<NamedLocalizer>& localizers,
           std::vector<std::unique_ptr<RunSink>>& sinks)
    : config_(std::move(config)),
      localizers_(localizers),
      sinks_(sinks),
      costs_(localizers.size()),
      driver_(index_of(config_.drive_by, "drive.by")),
      watched_(index_of(config_.watch, "kidnap.localizer")) {
  for (const LocalizerOrder& order : config_.orders) {
    (void)index_of(order.localizer, "localizer.name");
  }
  const auto drives = [](const NamedLocalizer& each) { return static_cast<bool>(each.velocity); };
  if (std::ranges::count_if(localizers_, drives) > 1) {
    throw std::invalid_argument("two localizers drive the robot by their commands; let one do so");
  }
}

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

template <typename Body>
void Loop::call(std::size_t index, Body&& body) {
  Cost& cost = costs_[index];
  if (cost.is_lost || cost.is_off) return;
  const NamedLocalizer& named = localizers_[index];
  const std::chrono::nanoseconds begin = thread_cpu_time();
  try {
    body(*named.localizer);
  } catch (const LocalizerFailure& failure) {
    lose(index, failure.what());
  }
  cost.since_scan += thread_cpu_time() - begin;
}

/// The run goes on without the localizer.
void Loop::lose(std::size_t index, const std::string& what) {
  const std::string& name = localizers_[index].name;
  costs_[index].is_lost = true;
  lost_.push_back({name, what});
  untold_.push_back({now_, FailureEvent{what, name}});
}

void Loop::take_news(std::size_t index) {
  const NamedLocalizer& named = localizers_[index];
  if (!named.news) return;
  for (std::string& sentence : named.news()) {
    untold_.push_back({now_, NodeEvent{std::move(sentence), named.name}});
  }
}

/// Adds what a localizer used elsewhere since the last call to its cost.
void Loop::add_outside(std::size_t index) {
  if (!localizers_[index].outside_cpu) return;
  Cost& cost = costs_[index];
  const std::chrono::nanoseconds now = localizers_[index].outside_cpu();
  cost.since_scan += now - cost.outside;
  cost.outside = now;
}

std::map<std::string, OutsideUse> Loop::finish_localizers() {
  std::map<std::string, OutsideUse> use;
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    if (!localizers_[i].finish) continue;
    const OutsideUse& own = use[localizers_[i].name] = localizers_[i].finish();
    localizers_cpu_ += std::max(own.cpu - costs_[i].outside, std::chrono::nanoseconds(0));
  }
  return use;
}

void Loop::run(SensorSource& source) {
  begin();
  while (step(source)) {
  }
  finish(source);
}

void Loop::begin() {
  begin_ = wall_time();
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    call(i, [&](auto& localizer) { localizer.initialize(config_.start); });
  }
}

bool Loop::step(SensorSource& source) {
  const std::optional<Frame> frame = source.next();
  if (!frame) return false;
  carry_out_orders(frame->stamp);
  now_ = frame->stamp;
  take(source, *frame);
  tell_failures();
  return true;
}

void Loop::add(const LocalizerOrder& order) {
  (void)index_of(order.localizer, "localizer.name");
  const auto later = [](const LocalizerOrder& a, const LocalizerOrder& b) { return a.at < b.at; };
  const auto begin = config_.orders.begin() + static_cast<std::ptrdiff_t>(next_order_);
  config_.orders.insert(std::upper_bound(begin, config_.orders.end(), order, later), order);
}

/// Those at or after the newest frame wait for later ones.
void Loop::carry_out_orders(Stamp before) {
  while (next_order_ < config_.orders.size() && config_.orders[next_order_].at < before) {
    carry_out(config_.orders[next_order_++]);
  }
}

void Loop::carry_out(const LocalizerOrder& order) {
  using What = LocalizerOrder::What;
  const std::size_t index = index_of(order.localizer, "localizer.name").value();
  costs_[index].is_off = order.what == What::kOff;
  call(index, [&](auto& localizer) {
    localizer.initialize(order.what == What::kInitialize ? order.pose : std::nullopt);
  });
  RunEvent event{order.at, OperatorEvent{order.what, order.localizer}};
  if (order.pose) event.T_map_to = order.pose->T_map_base;
  tell_sinks([&](RunSink& sink) { sink.on_event(event); });
}

void Loop::finish(const SensorSource& source) {
  RunTiming timing;
  timing.outside = finish_localizers();
  timing.load_s = config_.load_s;
  timing.wall_s = config_.load_s + localization::seconds(wall_time() - begin_);
  for (const auto& [stage, time] : source.cpu_by_stage()) {
    timing.cpu_s[stage] = localization::seconds(time);
  }
  timing.cpu_s["localizers"] = localization::seconds(localizers_cpu_);
  timing.cpu_s["sinks"] = localization::seconds(sinks_cpu_);
  tell_sinks([&](RunSink& sink) { sink.finish(std::max(now_, source.duration()), timing); });
  is_finished_ = true;
  outputs_.rethrow();
}

/// Those of the start are told after the first frame, which has the first known stamp.
void Loop::tell_failures() {
  for (RunEvent& event : std::exchange(untold_, {})) {
    event.stamp = now_;
    tell_sinks([&](RunSink& sink) { sink.on_event(event); });
  }
}

void Loop::take(SensorSource& source, const Frame& frame) {
  std::visit(
      [&]<typename Data>(const Data& data) {
        if constexpr (std::is_same_v<Data, OdometryFrame>) {
          take(source, data);
        } else if constexpr (std::is_same_v<Data, ScanFrame>) {
          take(data, frame.stamp);
        } else if constexpr (std::is_same_v<Data, RunEvent>) {
          take(data);
        } else {
          pass_on(data);
        }
      },
      frame.data);
}

void Loop::take(const RunEvent& event) {
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    if (!localizers_[i].relocalize_at_kidnap || !event.is<KidnapEvent>()) continue;
    call(i, [&](auto& localizer) { localizer.initialize(std::nullopt); });
  }
  tell_sinks([&](RunSink& sink) { sink.on_event(event); });
}

template <typename Reading>
void Loop::pass_on(const Reading& reading) {
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    call(i, [&](auto& localizer) { give(reading, localizer); });
  }
  tell_sinks([&](RunSink& sink) { tell(reading, sink); });
}

void Loop::take(SensorSource& source, const OdometryFrame& frame) {
  T_odom_base_.add(frame.odometry.stamp, frame.odometry.T_odom_base);
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    call(i, [&](auto& localizer) { localizer.on_odometry(frame.odometry); });
  }
  drive(source);
  report(source, frame.odometry);
  tell_sinks([&](RunSink& sink) { sink.on_odometry(frame); });
}

/// An estimate advanced by the odometry since its scan; nothing if odometry does not reach back to
/// it.
std::optional<SE2> Loop::carried_on(const localization::Estimate& estimate,
                                    const SE2& T_odom_base) const {
  const auto T_odom_scan = T_odom_base_.at(estimate.stamp);
  if (!T_odom_scan) return std::nullopt;
  return estimate.T_map_base * T_odom_scan->inverse() * T_odom_base;
}

std::vector<std::optional<SE2>> Loop::estimates() const {
  std::vector<std::optional<SE2>> poses(localizers_.size());
  if (T_odom_base_.empty()) return poses;
  const auto T_odom_base = T_odom_base_.at(T_odom_base_.newest());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto estimate = estimate_of(i);
    if (estimate && T_odom_base) poses[i] = carried_on(*estimate, *T_odom_base);
  }
  return poses;
}

/// Nothing of a localizer that is left out.
std::optional<localization::Estimate> Loop::estimate_of(std::size_t index) const {
  if (costs_[index].is_lost || costs_[index].is_off) return std::nullopt;
  return localizers_[index].localizer->estimate();
}

/// The commands of a localizer that is lost or off stop the robot.
void Loop::drive(SensorSource& source) const {
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    if (!localizers_[i].velocity) continue;
    const bool heard = !costs_[i].is_lost && !costs_[i].is_off;
    source.set_velocity(heard ? localizers_[i].velocity() : BaseVelocity{});
  }
}

/// Passes estimates to the source: the driving localizer's, and the watched one's unless it is
/// lost.
void Loop::report(SensorSource& source, const Odometry& odometry) const {
  if (driver_) {
    const auto estimate = estimate_of(*driver_);
    source.set_drive_pose(estimate ? carried_on(*estimate, odometry.T_odom_base) : std::nullopt);
  }
  if (watched_) {
    const auto estimate = estimate_of(*watched_);
    const bool sure = estimate && !estimate->lost;
    const double z = sure && estimate->footing ? estimate->footing->z : 0.0;
    source.set_watched_pose(sure ? carried_on(*estimate, odometry.T_odom_base) : std::nullopt, z);
  }
}

void Loop::take(const ScanFrame& frame, Stamp delivered) {
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    call(i, [&](auto& localizer) { localizer.on_scan(frame.scan); });
    add_outside(i);
    take_news(i);
  }
  const ScanRecord record = record_of(frame, delivered);
  tell_sinks([&](RunSink& sink) { sink.on_scan(record); });
}

ScanRecord Loop::record_of(const ScanFrame& frame, Stamp delivered) {
  ScanRecord record;
  record.stamp = frame.scan.stamp;
  record.delivered = delivered;
  record.true_pose = frame.true_pose;
  if (!T_odom_base_.empty()) record.T_odom_base = *T_odom_base_.at(T_odom_base_.newest());
  record.scan = frame.scan;
  record.people = frame.people;
  record.truth = frame.truth;
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    LocalizerRecord localizer;
    localizer.name = localizers_[i].name;
    localizer.estimate = estimate_of(i);
    if (localizer.estimate && localizer.estimate->stamp != record.stamp) {
      localizer.estimate.reset();  // It belongs to an older scan: this one was dropped.
    }
    localizer.diagnostics = localizers_[i].localizer->diagnostics();
    localizer.update_cpu = costs_[i].since_scan;
    localizer.stage_cpu = localizer.diagnostics.cpu_by_stage;
    for (auto& [stage, time] : localizer.stage_cpu) time -= costs_[i].stages[stage];
    localizers_cpu_ += costs_[i].since_scan;
    costs_[i].since_scan = {};
    costs_[i].stages = localizer.diagnostics.cpu_by_stage;
    record.localizers.push_back(std::move(localizer));
  }
  return record;
}

/// A sink that throws hears no more; the others go on.
template <typename Body>
void Loop::tell_sinks(Body&& body) {
  const std::chrono::nanoseconds begin = thread_cpu_time();
  broken_.resize(sinks_.size());
  for (std::size_t i = 0; i < sinks_.size(); ++i) {
    if (!broken_[i]) broken_[i] = !outputs_.make([&] { body(*sinks_[i]); });
  }
  sinks_cpu_ += thread_cpu_time() - begin;
}

}  // namespace castaway::testbed
