// workbench odometry: drift of odometry, simulated and recorded.
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "sim/sensor/odometry_profiles.hpp"
#include "tests/bench/workbench/commands.hpp"
#include "tests/bench/workbench/odometry_bench.hpp"
#include "tools/base/output/say.hpp"
#include "tools/build/recorded/carmen_source.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct OdometryArguments {
  std::vector<std::string> logs;
  OdometryBenchConfig config;
};

std::vector<DriftSegment> recorded_drift(const std::string& log, double length_m) {
  CarmenSource source(log);
  Frames frames;
  while (auto frame = source.next()) frames.push_back(std::move(*frame));
  return drift_segments(frames, length_m);
}

void print_row(const std::string& name, const std::vector<DriftSegment>& segments) {
  const auto mean = mean_drift(segments);
  if (!mean) return;
  print_out("{:<40} {:>8} {:>8.2f} {:>8.3f}\n", name, segments.size(), mean->percent,
            mean->deg_per_m);
  std::fflush(stdout);
}

/// Reads all logs before anything is simulated, so that errors are reported early.
std::vector<std::vector<DriftSegment>> drift_of_logs(const OdometryArguments& arguments) {
  std::vector<std::vector<DriftSegment>> drift;
  for (const std::string& log : arguments.logs) {
    drift.push_back(recorded_drift(log, arguments.config.length_m));
    if (mean_drift(drift.back())) continue;
    throw std::runtime_error(
        fmt::format("{}: no {} m with reference poses (TRUEPOS): give a log that has them", log,
                    arguments.config.length_m));
  }
  return drift;
}

int print_drift(const OdometryArguments& arguments) {
  const auto recorded = drift_of_logs(arguments);
  print_out("{:<40} {:>8} {:>8} {:>8}\n", fmt::format("over {} m", arguments.config.length_m),
            "segments", "%", "deg/m");
  for (const std::string& profile : sim::odometry_profile_names()) {
    print_row(profile, simulated_drift(profile, arguments.config));
  }
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    print_row(arguments.logs[i], recorded[i]);
  }
  return kDone;
}

}  // namespace

void add_odometry_command(Command& app) {
  auto arguments = std::make_shared<OdometryArguments>();
  Command command = app.add_command(
      "odometry", "Drift of the odometry profiles, and of recorded logs with reference poses");
  command.add_option("logs", arguments->logs, "CARMEN logs with TRUEPOS, .gz too");
  command.add_option("--seeds", arguments->config.seeds, "Robots of each profile").range(1, 1000);
  command.add_option("--duration", arguments->config.duration_s, "Simulated time of each [s]")
      .range(1.0, 1e5);
  command.add_option("--length", arguments->config.length_m, "Of a segment [m]").range(0.1, 1e4);
  command.footer("Example:\n  build/release/workbench odometry intel.log.gz --seeds 4");
  command.action([arguments] { return print_drift(*arguments); });
}

}  // namespace castaway::testbed
