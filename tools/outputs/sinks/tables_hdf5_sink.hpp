/// tables.h5: scans with their labels, odometry, people and events, for learning.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/base/formats/hdf5_file.hpp"
#include "tools/outputs/records/scan_row.hpp"

namespace castaway::testbed {

/// One HDF5 file with the columns of `TablesCsvSink` as numbers: a group /lidars/<name> with a row
/// for every scan (`ranges`, `classes` and `hits` have a column per beam), /odometry, /people,
/// /events, /objects, and the lists /classes and /localizers; in runs on several floors heights,
/// too. Unknown values are NaN. Attributes of
/// every table state its unit and meaning.
class TablesHdf5Sink final : public RunSink {
 public:
  /// `localizers`: names in the order of the run.
  TablesHdf5Sink(const std::filesystem::path& run_folder, std::vector<std::string> localizers,
                 std::shared_ptr<const LabelContext> context);

  void on_event(const RunEvent& event) override;
  void on_odometry(const OdometryFrame& frame) override;
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  /// Table ids of a lidar.
  struct LidarTables {
    int stamp = 0;
    int pose = 0;
    int above = -1;  ///< -1 on one floor.
    int odometry = 0;
    int since_kidnap = 0;
    int held = 0;
    int torn = 0;
    int occluded = 0;
    int ambiguity = 0;
    int lost = 0;
    int ranges = 0;
    int classes = 0;
    int hits = 0;
    int intensities = -1;  ///< -1 if the lidar measures no intensities.
  };

  int add_height(const std::string& path);
  LidarTables add_lidar(const ScanRecord& record);
  void add_beams(const std::string& group, const ScanRecord& record, LidarTables& tables);
  void describe_lidar(const std::string& group, const ScanRecord& record);
  void write_people(const ScanRecord& record);
  void write_events();
  void write_legend();

  std::shared_ptr<const LabelContext> context_;  // Shared by the sinks of a run.
  ScanLabeller labeller_;
  std::vector<std::string> localizers_;
  Hdf5File file_;
  std::map<std::string, LidarTables> lidars_;
  std::vector<RunEvent> events_;
  struct {
    int stamp, pose, truth;
    int above = -1;  ///< -1 on one floor.
  } odometry_;
  struct {
    int stamp, id, pose, velocity, gap;
  } people_;
};

}  // namespace castaway::testbed
