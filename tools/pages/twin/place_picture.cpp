#include "tools/pages/twin/place_picture.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "tools/pages/run/map_svg.hpp"
#include "tools/pages/twin/building_plot.hpp"

namespace castaway::testbed {
namespace {

constexpr double kReach = 12.0;  // [m]

/// Ends of the beams within reach, in map. [m]
std::vector<Eigen::Vector2d> ends_of(const LaserScan& scan, const SE2& T_map_base) {
  std::vector<Eigen::Vector2d> ends;
  const Eigen::Isometry3d T_map_laser = localization::to_se3(T_map_base) * scan.T_base_laser;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double r = scan.ranges[i];
    if (!(r > scan.range_min && r < scan.range_max)) continue;
    const double angle = scan.beam_angle(i);
    const Eigen::Vector3d p =
        T_map_laser * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), 0.0);
    if ((p.head<2>() - T_map_base.translation()).norm() < kReach) ends.emplace_back(p.head<2>());
  }
  return ends;
}

std::string robot_on_map(const RosMap& map, const SE2& T_map_base) {
  const Eigen::Vector2d p = map_pixel(map, T_map_base.translation());
  const Eigen::Vector2d tip = map_pixel(map, T_map_base * Eigen::Vector2d(0.6, 0.0));
  return fmt::format(
      "<path style=\"stroke:#009E73;fill:none\" stroke-width=\"{0:.2f}\" "
      "d=\"M{1:.1f} {2:.1f}L{3:.1f} {4:.1f}\"/>"
      "<circle cx=\"{1:.1f}\" cy=\"{2:.1f}\" r=\"{5:.2f}\" style=\"fill:#009E73\"/>",
      2.0 * map_stroke(map), p.x(), p.y(), tip.x(), tip.y(), 0.25 / map.resolution);
}

}  // namespace

std::string place_picture(const RosMap& map, const SE2& T_map_base, const LaserScan& in_log,
                          const LaserScan& in_twin) {
  const RosMap part = cut_out(map, T_map_base.translation(), kReach);
  const auto dots = [&](const LaserScan& scan, const char* color, double radius) {
    return dots_on_map(part, ends_of(scan, T_map_base), fmt::format("fill:{}", color).c_str(),
                       radius);
  };
  return map_svg(part, true,
                 dots(in_log, kLogColor, 1.4) + dots(in_twin, kTwinColor, 0.8) +
                     robot_on_map(part, T_map_base),
                 "scans of log and twin");
}

}  // namespace castaway::testbed
