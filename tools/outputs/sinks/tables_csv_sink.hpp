/// tables/*.csv: scans with their labels, odometry and people, for learning.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "tools/base/formats/csv.hpp"
#include "tools/outputs/records/scan_row.hpp"

namespace castaway::testbed {

/// tables/scans.csv: a row for every scan in order of delivery: stamp_s; lidar; x_m, y_m, yaw_rad
/// (true pose of base in map); odom_x_m, odom_y_m, odom_yaw_rad (odometry); since_kidnap_s; held,
/// torn (0, 1); occluded, ambiguity [0, 1]; lost_<localizer> (0, 1) for each localizer; ranges_m
/// (inf: no return, -inf: too close), classes, hits: one number per beam, separated by spaces.
/// `ScanRow` and `BeamClass` define the labels. In runs on several floors, true poses are followed
/// by z_m, roll_rad and pitch_rad.
///
/// tables/lidars.csv: beam geometry of each lidar, from its first scan. tables/odometry.csv: every
/// odometry reading with the true pose. tables/people.csv: every person at every scan.
/// tables/objects.csv: id, class and name of the objects that `hits` refers to.
class TablesCsvSink final : public RunSink {
 public:
  /// `localizers`: names in the order of the run. `heights`: it is on several floors.
  TablesCsvSink(const std::filesystem::path& run_folder, const std::vector<std::string>& localizers,
                std::shared_ptr<const LabelContext> context, bool heights = false);

  void on_event(const RunEvent& event) override { labeller_.add(event); }
  void on_odometry(const OdometryFrame& frame) override;
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  void write_height(const std::optional<Eigen::Isometry3d>& T_footprint_base,
                    CsvWriter& table) const;
  void write_lidar(const ScanRecord& record);
  void write_people(const ScanRecord& record);

  std::shared_ptr<const LabelContext> context_;  // Shared by the sinks of a run.
  ScanLabeller labeller_;
  std::size_t localizers_;
  bool heights_;
  CsvWriter scans_;
  CsvWriter lidars_;
  CsvWriter odometry_;
  CsvWriter people_;
  CsvWriter objects_;
  std::set<std::string> seen_;
};

}  // namespace castaway::testbed
