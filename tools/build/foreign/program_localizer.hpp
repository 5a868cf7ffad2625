/// A localizer that runs as a program: docs/protocol.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/base/process/child_process.hpp"
#include "tools/base/process/line_channel.hpp"
#include "tools/base/process/process_use.hpp"
#include "tools/build/foreign/answer.hpp"
#include "tools/build/foreign/message_text.hpp"
#include "tools/run/foreign_config.hpp"
#include "tools/run/outside_use.hpp"

namespace castaway::testbed {

/// Speaks to the program in lock step: it waits for the answer to every scan. Whatever the program
/// does wrong is thrown as LocalizerFailure.
class ProgramLocalizer final : public localization::Localizer {
 public:
  /// Starts the program. `log`: file for its standard error; empty: it shares ours. Throws
  /// std::runtime_error if it cannot be started.
  ProgramLocalizer(const ProgramConfig& config, Greeting greeting,
                   const std::filesystem::path& log);

  void initialize(const std::optional<localization::PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<localization::Estimate> estimate() const override;
  [[nodiscard]] localization::Diagnostics diagnostics() const override;

  /// CPU time of the program so far.
  std::chrono::nanoseconds cpu() { return use_.cpu(); }
  /// Says goodbye, gives the program a moment to end, and ends it.
  OutsideUse finish();

 private:
  std::string exchange(double timeout_s);

  ProgramConfig config_;
  Greeting greeting_;
  ChildProcess program_;
  LineChannel channel_;
  ProcessUse use_;
  bool is_ready_ = false;
  std::string unsent_;  ///< Lines that wait for the next exchange.
  std::vector<LidarFacts> told_;
  std::optional<Odometry> before_;
  Answer answer_;
};

}  // namespace castaway::testbed
