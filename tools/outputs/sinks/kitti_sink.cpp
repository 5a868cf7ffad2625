#include "tools/outputs/sinks/kitti_sink.hpp"

#include <cmath>

#include <fmt/format.h>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

std::string kitti_line(const SE2& T_map_base) {
  const double c = std::cos(T_map_base.yaw);
  const double s = std::sin(T_map_base.yaw);
  return fmt::format("{:.9f} {:.9f} 0 {:.9f} {:.9f} {:.9f} 0 {:.9f} 0 0 1 0\n", c, -s, T_map_base.x,
                     s, c, T_map_base.y);
}

std::string kitti_line(const Eigen::Isometry3d& T_map_base) {
  const Eigen::Matrix<double, 3, 4> M = T_map_base.matrix().topRows<3>();
  std::string line;
  for (Eigen::Index row = 0; row < M.rows(); ++row) {
    for (Eigen::Index column = 0; column < M.cols(); ++column) {
      line += fmt::format("{}{:.9f}", line.empty() ? "" : " ", M(row, column));
    }
  }
  return line + "\n";
}

void KittiSink::on_scan(const ScanRecord& record) {
  if (!record.true_pose || record.stamp <= newest_) return;
  newest_ = record.stamp;
  const SE2& T_map_base = record.true_pose->T_map_base;
  const auto& T_footprint_base = record.true_pose->T_footprint_base;
  poses_.write(T_footprint_base ? kitti_line(localization::to_se3(T_map_base) * *T_footprint_base)
                                : kitti_line(T_map_base));
  times_.write(fmt::format("{:.9f}\n", seconds(record.stamp)));
}

void KittiSink::finish(Stamp, const RunTiming&) {
  poses_.commit();
  times_.commit();
}

}  // namespace castaway::testbed
