#include "tools/ros/bag_frames.hpp"

#include <algorithm>

#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kBaseLink = "base_link";

ros::TransformStamped edge(Stamp stamp, const std::string& parent, const std::string& child,
                           const Eigen::Isometry3d& T_parent_child) {
  return {ros_header(stamp, parent), child, to_ros_transform(T_parent_child)};
}

}  // namespace

BagFrames::BagFrames(std::map<std::string, Eigen::Isometry3d> links,
                     const std::vector<BagLidar>& lidars, std::string base)
    : base_(std::move(base)), T_base_frame_(std::move(links)) {
  T_base_frame_.erase(base_);
  for (const BagLidar& lidar : lidars) {
    const bool taken = lidar.frame.empty() || lidar.frame == base_ || lidar.frame == kBaseLink ||
                       std::any_of(frame_of_lidar_.begin(), frame_of_lidar_.end(),
                                   [&](const auto& other) { return other.second == lidar.frame; });
    const std::string frame = taken ? lidar.name + "_frame" : lidar.frame;
    frame_of_lidar_[lidar.name] = frame;
    T_base_frame_[frame] = lidar.T_base_laser;
  }
}

std::string BagFrames::frame_of(const std::string& lidar) const {
  const auto found = frame_of_lidar_.find(lidar);
  return found == frame_of_lidar_.end() ? "laser" : found->second;
}

bool BagFrames::set_mount(const std::string& lidar, const Eigen::Isometry3d& T_base_laser) {
  const auto [frame, first] =
      T_base_frame_.try_emplace(frame_of(lidar), Eigen::Isometry3d::Identity());
  if (!first && frame->second.matrix() == T_base_laser.matrix()) return false;
  frame->second = T_base_laser;
  return true;
}

ros::TFMessage BagFrames::message(Stamp stamp) const {
  ros::TFMessage message;
  const auto link = T_base_frame_.find(kBaseLink);
  const bool has_link = link != T_base_frame_.end();
  if (has_link) message.transforms.push_back(edge(stamp, base_, kBaseLink, link->second));
  for (const auto& [frame, T_base_frame] : T_base_frame_) {
    if (frame == kBaseLink) continue;
    message.transforms.push_back(
        has_link ? edge(stamp, kBaseLink, frame, link->second.inverse() * T_base_frame)
                 : edge(stamp, base_, frame, T_base_frame));
  }
  return message;
}

}  // namespace castaway::testbed
