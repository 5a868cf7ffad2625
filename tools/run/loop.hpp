/// The loop: pulls frames from a source, pushes them into every localizer and notifies every sink.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "localization/geometry/transform_buffer.hpp"
#include "tools/base/files/attempts.hpp"
#include "tools/run/localizer_failure.hpp"
#include "tools/run/localizer_order.hpp"
#include "tools/run/outside_use.hpp"
#include "tools/run/run_sink.hpp"
#include "tools/run/sensor_source.hpp"

namespace castaway::testbed {

/// A localizer in a run.
struct NamedLocalizer {
  std::string name;  ///< Unique within the run.
  std::unique_ptr<localization::Localizer> localizer;
  /// Calls its global localization at every kidnap, as an operator would who saw the kidnap.
  bool relocalize_at_kidnap = false;
  /// CPU time that it used so far outside of the calling thread; empty: none.
  std::function<std::chrono::nanoseconds()> outside_cpu = {};
  /// What happened outside of castaway since the last call, in one sentence each; empty: nothing.
  std::function<std::vector<std::string>()> news = {};
  /// The velocity at which it drives the robot; empty: it does not.
  std::function<BaseVelocity()> velocity = {};
  /// Ends what it started outside of the calling thread; empty: nothing.
  std::function<OutsideUse()> finish = {};
};

/// A localizer without which a run went on.
struct LostLocalizer {
  std::string name;
  std::string what;  ///< E.g. "exited with 1".
};

/// "localizer 'mine' exited with 1".
std::string describe(const LostLocalizer& lost);

/// Throws LocalizerFailure describing the first one, if there is any.
void require_none(const std::vector<LostLocalizer>& lost);

/// Settings of a run.
struct LoopConfig {
  /// Initial pose given to the localizers; nothing: unknown.
  std::optional<localization::PoseWithCovariance> start;
  std::string drive_by;  ///< Localizer whose estimate the robot drives by; empty: none.
  std::string watch;     ///< Localizer whose estimate triggers kidnaps; empty: none.
  double load_s = 0.0;   ///< [s] Wall time that loading took, for `RunTiming`.
  std::vector<LocalizerOrder> orders{};  ///< In order of time.
};

/// Plays one run in order of time and measures the CPU time of localizers and sinks.
class Loop {
 public:
  /// Localizers and sinks must outlive the loop. Throws std::invalid_argument if `drive_by` or
  /// `watch` names no localizer, or if two localizers drive the robot.
  Loop(LoopConfig config, std::vector<NamedLocalizer>& localizers,
       std::vector<std::unique_ptr<RunSink>>& sinks);

  /// Plays the source to its end, then finishes the sinks. A localizer that throws LocalizerFailure
  /// is left out from then on, and so is a sink that throws a std::exception.
  void run(SensorSource& source);

  /// The same in parts: `begin` once, `step` for each frame until it returns false, then `finish`.
  /// `finish` throws what the first sink threw that failed, once the others are finished.
  void begin();
  bool step(SensorSource& source);
  void finish(const SensorSource& source);
  /// Throws what the first sink threw that failed, if one did.
  void require_outputs() const { outputs_.rethrow(); }
  /// Ends what localizers started, without `finish`. Returns what they used, by name.
  std::map<std::string, OutsideUse> finish_localizers();
  /// Adds an order, not before `now`, as if it had been configured.
  /// @throws std::invalid_argument if the run has no such localizer.
  void add(const LocalizerOrder& order);
  /// Estimates carried on to the newest odometry; nothing of a localizer without one.
  [[nodiscard]] std::vector<std::optional<SE2>> estimates() const;
  /// Stamp of the last frame.
  [[nodiscard]] Stamp now() const { return now_; }
  /// True once all sinks had their turn to finish, also if one of them failed.
  [[nodiscard]] bool is_finished() const { return is_finished_; }
  /// The localizers that were left out.
  [[nodiscard]] const std::vector<LostLocalizer>& lost() const { return lost_; }

 private:
  /// Calls `body(localizer)` and adds its CPU time to the cost.
  template <typename Body>
  void call(std::size_t index, Body&& body);
  void lose(std::size_t index, const std::string& what);
  void take_news(std::size_t index);
  void add_outside(std::size_t index);
  void tell_failures();
  void carry_out_orders(Stamp before);
  void carry_out(const LocalizerOrder& order);
  void take(SensorSource& source, const Frame& frame);
  void take(SensorSource& source, const OdometryFrame& frame);
  void take(const RunEvent& event);
  template <typename Reading>
  void pass_on(const Reading& reading);  ///< To localizers and sinks.
  void take(const ScanFrame& frame, Stamp delivered);
  [[nodiscard]] std::optional<std::size_t> index_of(const std::string& name, const char* key) const;
  void drive(SensorSource& source) const;
  void report(SensorSource& source, const Odometry& odometry) const;
  [[nodiscard]] std::optional<localization::Estimate> estimate_of(std::size_t index) const;
  [[nodiscard]] std::optional<SE2> carried_on(const localization::Estimate& estimate,
                                              const SE2& T_odom_base) const;
  ScanRecord record_of(const ScanFrame& frame, Stamp delivered);
  template <typename Body>
  void tell_sinks(Body&& body);

  /// CPU time of a localizer and of its stages at its last record.
  struct Cost {
    std::chrono::nanoseconds since_scan{};
    std::map<std::string, std::chrono::nanoseconds> stages;
    std::chrono::nanoseconds outside{};  ///< Of `outside_cpu` at the last call.
    bool is_lost = false;
    bool is_off = false;
  };
  LoopConfig config_;
  std::vector<NamedLocalizer>& localizers_;
  std::vector<std::unique_ptr<RunSink>>& sinks_;
  std::vector<Cost> costs_;
  localization::TransformBuffer T_odom_base_;
  std::optional<std::size_t> driver_;
  std::optional<std::size_t> watched_;
  Stamp now_{};  ///< Of the newest frame.
  std::size_t next_order_ = 0;
  std::chrono::nanoseconds begin_{};  ///< Wall time.
  std::vector<LostLocalizer> lost_;
  std::vector<bool> broken_;  ///< By sink: it threw.
  Attempts outputs_;          ///< Of all sinks.
  bool is_finished_ = false;
  std::vector<RunEvent> untold_;  ///< Events of the loop's own that sinks do not know yet.
  std::chrono::nanoseconds localizers_cpu_{};
  std::chrono::nanoseconds sinks_cpu_{};
};

}  // namespace castaway::testbed
