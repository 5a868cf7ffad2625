#include "tools/outputs/sinks/points_sink.hpp"

#include <utility>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/file_name.hpp"

namespace castaway::testbed {

std::string ply_text(const std::vector<CloudPoint>& cloud) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty "
      "float "
      "z\nproperty float intensity\nproperty int label\nend_header\n",
      cloud.size());
  for (const CloudPoint& point : cloud) {
    fmt::format_to(std::back_inserter(text), "{:.4f} {:.4f} {:.4f} {:.4g} {}\n", point.p_base.x(),
                   point.p_base.y(), point.p_base.z(), point.intensity, point.label);
  }
  return text;
}

PointsSink::PointsSink(const std::filesystem::path& run_folder, double every_s)
    : folder_(run_folder / "points"), period_(localization::from_seconds(every_s)) {
  std::filesystem::create_directories(folder_);
}

void PointsSink::on_scan(const ScanRecord& record) {
  const auto [next, first] = next_.try_emplace(record.scan.lidar, record.stamp);
  if (record.stamp < next->second) return;
  next->second += period_;
  const std::string lidar = file_name_of(record.scan.lidar);
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(record.stamp).count();
  write_file(folder_ / fmt::format("{}-{:07d}.ply", lidar, ms), ply_text(record.truth.cloud));
}

}  // namespace castaway::testbed
