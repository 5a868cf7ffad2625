// A robot that does not know where it is, finds out, is carried elsewhere and finds out again.
#include <cstdio>
#include <optional>
#include <variant>

#include <castaway/mh_amcl.hpp>

#include "adapter.hpp"
#include "floor_plan.hpp"
#include "robot.hpp"

namespace {

constexpr double kEnd = 90.0;        // [s]
constexpr double kCarriedAt = 45.0;  // [s]
constexpr double kGood = 0.2;        // [m]

void print(double time_s, const castaway::Estimate& estimate, const castaway::Pose2& T_map_base) {
  std::printf(
      "%5.1f s: x %6.2f m, y %6.2f m, yaw %5.2f rad, %s with probability %.2f, off by %.2f m\n",
      time_s, estimate.T_map_base.x, estimate.T_map_base.y, estimate.T_map_base.yaw,
      estimate.lost ? "lost" : "found", estimate.probability,
      castaway::distance(estimate.T_map_base, T_map_base));
}

}  // namespace

int main() {
  const castaway::OccupancyGrid plan = floor_plan();
  Robot robot(plan);
  castaway::MhAmcl localizer(plan);
  localizer.initialize(std::nullopt);  // Anywhere on the map.
  bool carried = false;
  double next_print = 1.0;
  for (double now = 0.0; now < kEnd;) {
    const Message message = robot.next();
    if (const auto* wheels = std::get_if<WheelMessage>(&message)) {
      localizer.on_odometry(to_odometry(*wheels));
      now = wheels->time_s;
      continue;
    }
    localizer.on_scan(to_scan(std::get<SweepMessage>(message)));
    const std::optional<castaway::Estimate> estimate = localizer.estimate();
    if (estimate && now >= next_print) {
      print(now, *estimate, robot.T_map_base());
      next_print += 5.0;
    }
    if (now >= kCarriedAt && !carried) {
      carried = true;
      robot.carry({9.0, 6.0, 2.0});
      std::puts("carried elsewhere");
    }
  }
  const std::optional<castaway::Estimate> last = localizer.estimate();
  const bool good =
      last && !last->lost && castaway::distance(last->T_map_base, robot.T_map_base()) < kGood;
  std::puts(good ? "found itself" : "did not find itself");
  return good ? 0 : 1;
}
