#include "sim/navigation/mover_watch.hpp"

#include <algorithm>

namespace castaway::sim {
namespace {

constexpr double kMapped = 0.25;  // [m] End points this close to a mapped obstacle belong to it.
constexpr double kStride = 0.5;   // [m] A leg can be this far from the middle of a walking person.
constexpr double kSeenAgo = 0.2;  // [s] End points are at most this old.

}  // namespace

std::vector<Mover> transform_movers(std::vector<Mover> movers, const Pose2& T_b_a) {
  const Pose2 turn{0.0, 0.0, T_b_a.yaw};
  for (Mover& mover : movers) mover = {T_b_a * mover.p, turn * mover.velocity};
  return movers;
}

MoverWatch::MoverWatch(const Grid& map) : mapped_(map, kMapped) {}

void MoverWatch::update(LiveScan& live, const Pose2& T_map_base) {
  const Pose2 T_odom_base = live.T_odom_base();
  const Pose2 T_map_odom = T_map_base * inverse(T_odom_base);
  for (std::vector<SeenPoint>& points : live.take_new_scans()) {
    std::erase_if(points, [&](const SeenPoint& point) {
      return mapped_.clearance_at(T_map_odom * point.p) <= kMapped;
    });
    movers_.update(points);
  }
  seen_ = transform_movers(movers_.extrapolate(live.stamp()), inverse(T_odom_base));
  moving_ = seen_;
  std::erase_if(moving_, [](const Mover& mover) { return mover.stands(); });
}

Eigen::Vector2d MoverWatch::velocity_at(const Eigen::Vector2d& p_base,
                                        const Pose2& T_map_base) const {
  for (const Mover& mover : moving_) {
    const Eigen::Vector2d way = kSeenAgo * mover.velocity;
    const double ago = std::clamp((mover.p - p_base).dot(way) / way.squaredNorm(), 0.0, 1.0);
    if ((mover.p - ago * way - p_base).norm() >= kStride) continue;
    const bool mapped = mapped_.clearance_at(T_map_base * p_base) <= kMapped;
    return mapped ? Eigen::Vector2d::Zero().eval() : mover.velocity;
  }
  return Eigen::Vector2d::Zero();
}

}  // namespace castaway::sim
