#include "tools/build/foreign/program_localizer.hpp"

#include <algorithm>
#include <utility>

#include "tools/build/foreign/odometry_twist.hpp"
#include "tools/run/localizer_failure.hpp"

namespace castaway::testbed {
namespace {

/// The files of a command, found beside the scenario if they are not in the current folder.
std::vector<std::string> find_files(std::vector<std::string> command,
                                    const std::filesystem::path& folder) {
  const bool is_in_path = command.front().find('/') == std::string::npos;
  for (std::size_t i = is_in_path ? 1 : 0; i < command.size(); ++i) {
    command[i] = find_beside(command[i], folder);
  }
  return command;
}

}  // namespace

ProgramLocalizer::ProgramLocalizer(const ProgramConfig& config, Greeting greeting,
                                   const std::filesystem::path& log)
    : config_(config),
      greeting_(std::move(greeting)),
      program_(find_files(config.command, config.folder), log),
      channel_(program_),
      use_(program_.id()),
      told_(greeting_.lidars) {
  append_hello(greeting_, config_.params, unsent_);
}

std::string ProgramLocalizer::exchange(double timeout_s) {
  try {
    std::string line = channel_.exchange(unsent_, localization::from_seconds(timeout_s));
    unsent_.clear();
    return line;
  } catch (const std::runtime_error& error) {
    throw LocalizerFailure(error.what());
  }
}

void ProgramLocalizer::initialize(const std::optional<localization::PoseWithCovariance>& start) {
  if (!is_ready_) {
    const std::string line = exchange(config_.start_timeout_s);
    try {
      read_ready(line);
    } catch (const std::invalid_argument& error) {
      throw LocalizerFailure(error.what());
    }
    is_ready_ = true;
  }
  append_initialize(start, unsent_);
  answer_ = {};
}

void ProgramLocalizer::on_odometry(const Odometry& odometry) {
  append_odometry(odometry, twist_between(before_, odometry), unsent_);
  before_ = odometry;
}

void ProgramLocalizer::on_scan(const LaserScan& scan) {
  auto told = std::find_if(told_.begin(), told_.end(),
                           [&](const LidarFacts& lidar) { return lidar.name == scan.lidar; });
  if (told == told_.end() || !fits(*told, scan)) {
    if (told == told_.end()) told = told_.emplace(told_.end());
    *told = lidar_facts(scan);
    append_lidar(*told, unsent_);
  }
  append_scan(scan, unsent_);
  const std::string line = exchange(config_.timeout_s);
  try {
    answer_ = read_estimate(line, scan.stamp);
  } catch (const std::invalid_argument& error) {
    throw LocalizerFailure(error.what());
  }
}

std::optional<localization::Estimate> ProgramLocalizer::estimate() const {
  return answer_.estimate;
}

localization::Diagnostics ProgramLocalizer::diagnostics() const {
  localization::Diagnostics diagnostics;
  diagnostics.populations = answer_.populations;
  return diagnostics;
}

OutsideUse ProgramLocalizer::finish() {
  constexpr std::chrono::seconds kPatience(2);
  OutsideUse use;
  use.peak_memory_mb = use_.peak_memory_mb();
  append_bye(unsent_);
  channel_.say_last(unsent_, kPatience);
  program_.close_input();
  (void)program_.how_it_ended(kPatience);
  use.cpu = program_.end();
  return use;
}

}  // namespace castaway::testbed
