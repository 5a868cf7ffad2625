#include "tools/sinks/kitti_sink.hpp"

#include <cmath>

#include <fmt/format.h>

namespace castaway::testbed {

std::string kitti_line(const SE2& T_map_base) {
  const double c = std::cos(T_map_base.yaw);
  const double s = std::sin(T_map_base.yaw);
  return fmt::format("{:.9f} {:.9f} 0 {:.9f} {:.9f} {:.9f} 0 {:.9f} 0 0 1 0\n", c, -s, T_map_base.x,
                     s, c, T_map_base.y);
}

void KittiSink::on_scan(const ScanRecord& record) {
  if (!record.T_map_base_true || record.stamp <= newest_) return;
  newest_ = record.stamp;
  poses_.write(kitti_line(*record.T_map_base_true));
  times_.write(fmt::format("{:.9f}\n", seconds(record.stamp)));
}

void KittiSink::finish(Stamp, const RunTiming&) {
  poses_.commit();
  times_.commit();
}

}  // namespace castaway::testbed
