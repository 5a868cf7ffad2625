#include "tools/play/run_files.hpp"

#include <utility>

#include "tools/outputs/sinks/errors_sink.hpp"
#include "tools/outputs/sinks/people_sink.hpp"
#include "tools/outputs/sinks/points_sink.hpp"
#include "tools/outputs/sinks/recording_sink.hpp"
#include "tools/outputs/sinks/scans_sink.hpp"
#include "tools/outputs/sinks/summary_sink.hpp"
#include "tools/outputs/sinks/tables_csv_sink.hpp"
#include "tools/outputs/sinks/tables_hdf5_sink.hpp"
#include "tools/outputs/sinks/timing_sink.hpp"
#include "tools/outputs/sinks/trajectory_sink.hpp"

namespace castaway::testbed {
namespace {

using Sinks = std::vector<std::unique_ptr<RunSink>>;

void add_tables(const RunFiles& files, const std::filesystem::path& folder, const RunInfo& info,
                Sinks& sinks) {
  sinks.push_back(std::make_unique<ErrorsSink>(folder, info));
  sinks.push_back(std::make_unique<TrajectorySink>(folder, info));
  sinks.push_back(std::make_unique<SummarySink>(folder, info));
  if (files.timing) sinks.push_back(std::make_unique<TimingSink>(folder, info));
  if (files.people_every_s > 0.0) {
    sinks.push_back(std::make_unique<PeopleSink>(folder, files.people_every_s));
  }
  if (files.label_name) sinks.push_back(std::make_unique<ScansSink>(folder, files.label_name));
  if (files.tables_csv) {
    sinks.push_back(
        std::make_unique<TablesCsvSink>(folder, info.localizers, files.labels, info.heights));
  }
  if (files.tables_hdf5) {
    sinks.push_back(std::make_unique<TablesHdf5Sink>(folder, info.localizers, files.labels));
  }
  if (files.points_every_s > 0.0) {
    sinks.push_back(std::make_unique<PointsSink>(folder, files.points_every_s));
  }
}

RecordingConfig recording_config(const RunFiles& files, Stamp duration) {
  RecordingConfig config;
  config.robot_radius_m = files.picture_world.robot_radius;
  config.scan_every_s = scan_period(seconds(duration));
  config.detail_every_s = detail_period(seconds(duration));
  if (files.scene) config.scene = page_scene_json(*files.scene, kReportSceneBytes);
  config.levels = files.levels;
  return config;
}

}  // namespace

ReportSink::ReportSink(ReportWriter write, std::filesystem::path run_folder, RosMap map,
                       std::shared_ptr<const LevelMaps> levels)
    : write_(std::move(write)),
      run_folder_(std::move(run_folder)),
      map_(std::move(map)),
      levels_(std::move(levels)) {}

void ReportSink::finish(Stamp, const RunTiming&) {
  write_(run_folder_, {map_, levels_ ? *levels_ : LevelMaps{}});
}

RunSinks build_sinks(const std::filesystem::path& folder, const RunInfo& info, const RosMap& map,
                     Stamp duration, RunFiles files) {
  RunSinks built;
  const RosMap shown = known_part(map);
  Sinks& sinks = built.sinks;
  add_tables(files, folder, info, sinks);
  for (auto& sink : export_sinks(folder, info, map, files.exports)) {
    sinks.push_back(std::move(sink));
  }
  if (files.report && files.player) {
    sinks.push_back(
        std::make_unique<RecordingSink>(folder, info, shown, recording_config(files, duration)));
  }
  if (files.camera) {
    sinks.push_back(
        std::make_unique<CameraSink>(folder, *files.camera, files.picture_world, files.instances));
  }
  if (files.film) sinks.push_back(std::make_unique<FilmSink>(*files.film, files.picture_world));
  if (files.pictures) {
    auto pictures = std::make_unique<PictureSink>(folder, info, std::move(files.picture_world),
                                                  *files.pictures);
    if (pictures->missing()) built.warnings.push_back("no pictures: " + *pictures->missing());
    sinks.push_back(std::move(pictures));
  }
  if (files.report) {
    sinks.push_back(std::make_unique<ReportSink>(files.report, folder, shown, files.levels));
  }
  return built;
}

}  // namespace castaway::testbed
