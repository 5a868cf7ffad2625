#include "tools/outputs/sinks/tables_csv_sink.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// Joins numbers formatted as `format` with spaces.
template <typename T>
std::string join_cells(const std::vector<T>& values, fmt::format_string<const T&> format) {
  std::string text;
  for (const T& value : values) {
    if (!text.empty()) text += ' ';
    fmt::format_to(std::back_inserter(text), format, value);
  }
  return text;
}

void add_names(std::initializer_list<const char*> names, std::vector<std::string>& header) {
  header.insert(header.end(), names.begin(), names.end());
}

std::vector<std::string> scan_header(const std::vector<std::string>& localizers, bool heights) {
  std::vector<std::string> header{"stamp_s", "lidar", "x_m", "y_m", "yaw_rad"};
  if (heights) add_names({"z_m", "roll_rad", "pitch_rad"}, header);
  add_names({"odom_x_m", "odom_y_m", "odom_yaw_rad", "since_kidnap_s", "held", "torn", "occluded",
             "ambiguity"},
            header);
  for (const std::string& name : localizers) header.push_back("lost_" + name);
  add_names({"ranges_m", "classes", "hits"}, header);
  return header;
}

std::vector<std::string> odometry_header(bool heights) {
  std::vector<std::string> header{"stamp_s", "odom_x_m", "odom_y_m", "odom_yaw_rad",
                                  "x_m",     "y_m",      "yaw_rad"};
  if (heights) add_names({"z_m", "roll_rad", "pitch_rad"}, header);
  return header;
}

}  // namespace

TablesCsvSink::TablesCsvSink(const std::filesystem::path& run_folder,
                             const std::vector<std::string>& localizers,
                             std::shared_ptr<const LabelContext> context, bool heights)
    : context_(context),
      labeller_(std::move(context)),
      localizers_(localizers.size()),
      heights_(heights),
      scans_(run_folder / "tables/scans.csv", scan_header(localizers, heights)),
      lidars_(run_folder / "tables/lidars.csv",
              {"lidar", "frame", "beams", "angle_min_rad", "angle_increment_rad",
               "time_increment_s", "range_min_m", "range_max_m", "mount_x_m", "mount_y_m",
               "mount_z_m", "mount_roll_rad", "mount_pitch_rad", "mount_yaw_rad"}),
      odometry_(run_folder / "tables/odometry.csv", odometry_header(heights)),
      people_(run_folder / "tables/people.csv",
              {"stamp_s", "id", "x_m", "y_m", "yaw_rad", "vx_mps", "vy_mps", "gap_m"}),
      objects_(run_folder / "tables/objects.csv", {"id", "class", "class_name", "name"}) {}

void TablesCsvSink::on_odometry(const OdometryFrame& frame) {
  odometry_.number(seconds(frame.odometry.stamp)).pose(frame.odometry.T_odom_base);
  odometry_.pose(T_map_base_of(frame.true_pose));
  write_height(T_footprint_base_of(frame.true_pose), odometry_);
  odometry_.end_row();
}

void TablesCsvSink::write_height(const std::optional<Eigen::Isometry3d>& T_footprint_base,
                                 CsvWriter& table) const {
  if (!heights_) return;
  const auto above = height_roll_pitch(T_footprint_base);
  for (const Eigen::Index i : {0, 1, 2}) above ? table.number((*above)[i]) : table.empty();
}

void TablesCsvSink::write_lidar(const ScanRecord& record) {
  const LaserScan& scan = record.scan;
  if (!seen_.insert(scan.lidar).second) return;
  lidars_.text(scan.lidar).text(record.truth.frame);
  lidars_.count(static_cast<std::int64_t>(scan.ranges.size()));
  lidars_.number(scan.angle_min, 9).number(scan.angle_increment, 9);
  lidars_.number(seconds(scan.time_increment), 9).number(scan.range_min).number(scan.range_max);
  const auto& mount = scan.T_base_laser.translation();
  const Eigen::Vector3d turn = roll_pitch_yaw(scan.T_base_laser.linear());
  lidars_.number(mount.x()).number(mount.y()).number(mount.z());
  lidars_.number(turn.x()).number(turn.y()).number(turn.z()).end_row();
}

void TablesCsvSink::write_people(const ScanRecord& record) {
  for (const PersonTruth& person : record.people.people) {
    people_.number(seconds(record.stamp)).count(person.id).pose(person.T_map_person);
    people_.number(person.velocity.x(), 3).number(person.velocity.y(), 3);
    people_.number(person.gap_m, 3).end_row();
  }
}

void TablesCsvSink::on_scan(const ScanRecord& record) {
  const ScanRow row = labeller_.row_of(record);
  write_lidar(record);
  write_people(record);
  scans_.number(row.stamp_s).text(record.scan.lidar).pose(row.T_map_base);
  write_height(T_footprint_base_of(record.true_pose), scans_);
  scans_.pose(row.T_odom_base);
  scans_.number(row.since_kidnap_s).count(row.held ? 1 : 0).count(row.torn ? 1 : 0);
  scans_.number(row.occluded, 4).number(row.ambiguity, 4);
  for (std::size_t i = 0; i < localizers_; ++i) {
    i < row.lost.size() ? scans_.count(row.lost[i]) : scans_.empty();
  }
  scans_.text(join_cells(record.scan.ranges, "{:.4f}")).text(join_cells(row.classes, "{}"));
  scans_.text(join_cells(row.hits, "{}")).end_row();
}

void TablesCsvSink::finish(Stamp, const RunTiming&) {
  for (const auto& [label, entry] : context_->legend.entries) {
    objects_.count(label).count(static_cast<int>(entry.of)).text(class_name(entry.of));
    objects_.text(entry.name).end_row();
  }
  for (CsvWriter* table : {&scans_, &lidars_, &odometry_, &people_, &objects_}) table->commit();
}

}  // namespace castaway::testbed
