/// Plays a replay into a run folder.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/base/output/output_folder.hpp"
#include "tools/build/ros2/bridge_config.hpp"
#include "tools/play/replay/recorded_log.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/run/run.hpp"

namespace castaway::testbed {

/// What a replay writes besides its tables.
struct ReplayOutputs {
  ReportWriter report;  ///< Writes the page; empty: none.
  bool pictures = true;
  double pictures_every_s = 0.0;          ///< [s] 0: of kidnaps and recoveries only.
  std::optional<BridgeOptions> bridge{};  ///< Lets nodes of ROS 2 look on.
};

/// The files that the replay reads.
std::vector<std::filesystem::path> inputs_of(const ReplaySession& session);

/// Builds the run; its files go into `folder`. Throws std::exception if it cannot be played.
Run build_replay(const ReplaySession& session, const RecordedLog& log,
                 const std::filesystem::path& folder, const ReplayOutputs& outputs);

/// Plays a replay into the folder `out`, which must not exist, without a word. Throws
/// std::exception if it fails.
void play_replay(const ReplaySession& session, const std::filesystem::path& out,
                 const ReportWriter& report);

}  // namespace castaway::testbed
