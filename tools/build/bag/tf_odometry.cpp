#include "tools/build/bag/tf_odometry.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {

void TfOdometry::add(const std::string& parent, const std::string& child, const Reading& reading) {
  edges_[{parent, child}].push_back(reading);
}

std::string TfOdometry::base_frame(const std::string& bag) const {
  if (edges_.size() == 1) return edges_.begin()->first.second;
  if (edges_.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: /tf holds no edge from a frame 'odom'; name an Odometry topic by --odom-topic", bag));
  }
  std::string edges;
  for (const auto& [edge, readings] : edges_) {
    edges += fmt::format("{}{} -> {}", edges.empty() ? "" : ", ", edge.first, edge.second);
  }
  throw std::runtime_error(
      fmt::format("{}: /tf holds {} edges that could be odometry ({}); record an Odometry topic "
                  "and name it by --odom-topic",
                  bag, edges_.size(), edges));
}

void TfOdometry::insert_into(Frames& frames) const {
  if (edges_.empty()) return;
  Frames merged;
  std::size_t next = 0;
  const auto move_up_to = [&](std::size_t end) {
    for (; next < end; ++next) merged.push_back(std::move(frames[next]));
  };
  for (const Reading& reading : edges_.begin()->second) {
    move_up_to(reading.before);
    Frame& frame = merged.emplace_back();
    frame.stamp = reading.logged;
    frame.data = OdometryFrame{{reading.stamp, reading.T_odom_base}, std::nullopt};
  }
  move_up_to(frames.size());
  frames = std::move(merged);
}

}  // namespace castaway::testbed
