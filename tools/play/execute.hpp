/// What `run` and `replay` share: sinks, the loop with its progress, and what is printed at the
/// end.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tools/formats/ros_map.hpp"
#include "tools/output/output_folder.hpp"
#include "tools/pictures/camera_sink.hpp"
#include "tools/pictures/film_sink.hpp"
#include "tools/pictures/picture_sink.hpp"
#include "tools/records/scan_row.hpp"
#include "tools/run/loop.hpp"
#include "tools/sinks/export_sinks.hpp"

namespace castaway::testbed {

struct RunPlan;

/// Makes a sink that writes into a folder.
using SinkMaker = std::function<std::unique_ptr<RunSink>(const std::filesystem::path& folder,
                                                         const RunPlan& plan)>;

/// A run ready to go.
struct RunPlan {
  RunInfo info;
  std::filesystem::path folder;                 ///< Where it leaves everything.
  std::string scenario_yaml;                    ///< Effective scenario.
  std::string made_by = "run";                  ///< Subcommand.
  std::vector<std::filesystem::path> inputs{};  ///< Files that the run reads.
  bool force = false;                           ///< The folder may hold other files, too.
  bool keep_list = true;  ///< False: leaves no list of files, as a part of a larger folder.
  LoopConfig loop;
  std::vector<NamedLocalizer> localizers;
  RosMap map;                             ///< What the localizers were given.
  std::optional<PictureConfig> pictures;  ///< Nothing: none are taken.
  std::optional<FilmConfig> film;         ///< Nothing: none is made.
  std::optional<CameraConfig> camera;     ///< Nothing: none.
  std::map<int, std::string> instances;   ///< What the camera's numbers stand for.
  PictureWorld picture_world;             ///< What pictures show besides the run.
  bool report = true;                     ///< Writes report.html.
  bool player = true;                     ///< Records the run for the report's player.
  double people_every_s = 0.0;            ///< [s] Between rows of people.csv; 0: not written.
  std::function<std::string(int)> label_name{};  ///< What beams hit, for scans.csv; empty: none.
  double points_every_s = 0.0;                   ///< [s] Between PLY files of a lidar; 0: none.
  ExportConfig exports{};                        ///< Formats of other tools.
  std::vector<SinkMaker> more_sinks{};
  std::shared_ptr<const LabelContext> labels{};  ///< Shared by sinks; nothing: no tables.
  bool tables_csv = false;                       ///< tables/*.csv
  bool tables_hdf5 = false;                      ///< tables.h5
  bool timing = true;   ///< timing.json and timing.csv, which no repetition gives again.
  bool json = false;    ///< Prints summary.json instead of words.
  bool silent = false;  ///< Prints no result.
  bool quiet = false;   ///< Prints nothing, no progress either.
};

/// What the run's folder is asked for.
OutputRequest output_request(const RunPlan& plan);

/// Runs and writes the run folder; prints progress and warnings unless `quiet`. Throws
/// std::exception where it fails.
void execute_run(RunPlan& plan, SensorSource& source);

/// Runs, writes the run folder, prints the result. Returns the exit code; throws std::exception if
/// the folder cannot be written.
int execute(RunPlan& plan, SensorSource& source);

}  // namespace castaway::testbed
