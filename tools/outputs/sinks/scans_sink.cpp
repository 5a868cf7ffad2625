#include "tools/outputs/sinks/scans_sink.hpp"

#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// Joins numbers formatted as `format` with spaces.
template <typename T>
std::string join_numbers(const std::vector<T>& values, fmt::format_string<const T&> format) {
  std::string text;
  for (const T& value : values) {
    if (!text.empty()) text += ' ';
    fmt::format_to(std::back_inserter(text), format, value);
  }
  return text;
}

}  // namespace

ScansSink::ScansSink(const std::filesystem::path& run_folder, std::function<std::string(int)> name)
    : scans_(run_folder / "scans.csv",
             {"stamp_s", "lidar", "frame", "angle_min_rad", "angle_increment_rad",
              "time_increment_s", "x_m", "y_m", "yaw_rad", "ranges_m", "intensities", "labels"}),
      names_(run_folder / "labels.csv", {"label", "name"}),
      name_(std::move(name)) {}

void ScansSink::on_scan(const ScanRecord& record) {
  const LaserScan& scan = record.scan;
  scans_.number(seconds(record.stamp)).text(scan.lidar).text(record.truth.frame);
  scans_.number(scan.angle_min, 9).number(scan.angle_increment, 9);
  scans_.number(seconds(scan.time_increment), 9).pose(T_map_base_of(record.true_pose));
  scans_.text(join_numbers(scan.ranges, "{:.4f}"))
      .text(join_numbers(record.truth.intensities, "{:.4g}"));
  scans_.text(join_numbers(record.truth.labels, "{}")).end_row();
  labels_.insert(record.truth.labels.begin(), record.truth.labels.end());
}

void ScansSink::finish(Stamp, const RunTiming&) {
  for (const int label : labels_) names_.count(label).text(name_(label)).end_row();
  names_.commit();
  scans_.commit();
}

}  // namespace castaway::testbed
