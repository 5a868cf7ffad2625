#include "tools/play/replay/play_replay.hpp"

#include <memory>
#include <utility>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/recorded/recorded_source.hpp"
#include "tools/build/ros2/build_ros2.hpp"
#include "tools/play/bridge.hpp"
#include "tools/play/execute.hpp"
#include "tools/play/run_files.hpp"
#include "tools/play/terminal.hpp"
#include "tools/scenario/files/bag_folder.hpp"

namespace castaway::testbed {
namespace {

RunFiles files_of(const RecordedLog& log, const ReplayOutputs& outputs) {
  RunFiles files;
  files.report = outputs.report;
  files.levels = log.levels;
  if (!outputs.pictures) return files;
  files.pictures = PictureConfig{outputs.pictures_every_s, true, 960, 720};
  files.picture_world.map = log.map;
  return files;
}

}  // namespace

std::vector<std::filesystem::path> inputs_of(const ReplaySession& session) {
  std::vector<std::filesystem::path> inputs{session.log};
  if (is_bag(session.log)) {
    for (const auto& file : bag_files(session.log)) inputs.push_back(file);
  }
  for (const std::string& map : {session.map, session.map3d}) {
    if (!map.empty()) inputs.emplace_back(map);
  }
  return inputs;
}

Run build_replay(const ReplaySession& session, const RecordedLog& log,
                 const std::filesystem::path& folder, const ReplayOutputs& outputs) {
  const RunInfo info = run_info(session, log);
  const auto source = spliced_source(log, session);
  Run run;
  run.loop.start = initial_pose(session, log, *source);
  run.loop.orders = session.orders;
  run.source = std::make_unique<RecordedSource>(all_frames(*source));
  LocalizerPlace place{log.map, session.map, log.lidars, folder};
  place.volume = log.volume;
  run.localizers = build_localizers(session.localizers, place, session.seed);
  write_file(folder / "scenario.yaml", emit_yaml(session.tree));
  RunSinks built =
      build_sinks(folder, info, log.map, run.source->duration(), files_of(log, outputs));
  for (const std::string& warning : built.warnings) print_warning(warning);
  run.sinks = std::move(built.sinks);
  if (outputs.bridge) {
    BridgeConfig bridge = bridge_config(*outputs.bridge, session.localizers);
    bridge.start = run.loop.start;
    bridge.messages.lidars = bag_lidars(log.lidars);
    run.sinks.push_back(build_bridge(info, log.map, std::move(bridge)));
  }
  return run;
}

void play_replay(const ReplaySession& session, const std::filesystem::path& out,
                 const ReportWriter& report) {
  const RecordedLog log = open_log(session);
  OutputFolder output({out, "replay", sha256(emit_yaml(session.tree)), inputs_of(session), false});
  Run run = build_replay(session, log, output.folder(), {report});
  (void)execute(run, output, true);
}

}  // namespace castaway::testbed
