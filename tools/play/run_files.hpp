/// The files of a run, and the sinks that write them.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/base/formats/level_map.hpp"
#include "tools/build/scene/page_scene.hpp"
#include "tools/outputs/pictures/camera_sink.hpp"
#include "tools/outputs/pictures/film_sink.hpp"
#include "tools/outputs/pictures/picture_sink.hpp"
#include "tools/outputs/records/scan_row.hpp"
#include "tools/outputs/sinks/export_sinks.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Renders the report from the files of other sinks, so it must come after them.
class ReportSink final : public RunSink {
 public:
  /// `levels`: null in a run on one floor.
  ReportSink(ReportWriter write, std::filesystem::path run_folder, RosMap map,
             std::shared_ptr<const LevelMaps> levels = nullptr);

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord&) override {}
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  ReportWriter write_;
  std::filesystem::path run_folder_;
  RosMap map_;
  std::shared_ptr<const LevelMaps> levels_;
};

/// What a run writes besides scenario.yaml, errors, trajectories and summary.json.
struct RunFiles {
  std::optional<PictureConfig> pictures;  ///< snapshots/; nothing: none.
  std::optional<FilmConfig> film;         ///< Nothing: none.
  std::optional<CameraConfig> camera;     ///< Nothing: none.
  std::map<int, std::string> instances;   ///< Names of the instances in the camera's images.
  PictureWorld picture_world;             ///< What pictures show besides the run.
  ReportWriter report{};                  ///< report.html; empty: none.
  bool player = true;                     ///< The recording for the report's player.
  std::optional<PageScene> scene;         ///< For the player; nothing: no 3-D view.
  double people_every_s = 0.0;            ///< [s] Between rows of people.csv; 0: not written.
  std::function<std::string(int)> label_name{};  ///< Names what beams hit; empty: no scans.csv.
  double points_every_s = 0.0;                   ///< [s] Between PLY files of a lidar; 0: none.
  ExportConfig exports{};                        ///< Formats of other tools.
  bool tables_csv = false;                       ///< tables/*.csv
  bool tables_hdf5 = false;                      ///< tables.h5
  std::shared_ptr<const LabelContext> labels{};  ///< For tables; shared by sinks.
  std::shared_ptr<const LevelMaps> levels{};     ///< Of a run on several floors, for its page.
  bool timing = true;  ///< timing.json and timing.csv, which differ in every repetition.
};

/// Sinks, and the reasons why files are missing.
struct RunSinks {
  std::vector<std::unique_ptr<RunSink>> sinks;
  std::vector<std::string> warnings;
};

/// Builds the sinks that write `files` into `folder`, in the order in which they must finish.
/// `map` is the localizers' map; `duration` is the run's, from which the player's rates follow.
/// Throws std::exception if a file cannot be written.
RunSinks build_sinks(const std::filesystem::path& folder, const RunInfo& info, const RosMap& map,
                     Stamp duration, RunFiles files);

}  // namespace castaway::testbed
