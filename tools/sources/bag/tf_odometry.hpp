/// Odometry as an edge of /tf.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/sources/recorded_source.hpp"

namespace castaway::testbed {

/// Collects the edges that could be odometry, until one is chosen.
class TfOdometry {
 public:
  /// A transform from an odometry frame to another.
  struct Reading {
    Stamp logged{};
    Stamp stamp{};
    SE2 T_odom_base;
    std::size_t before = 0;  ///< Index of the frame that it came before.
  };

  void add(const std::string& parent, const std::string& child, const Reading& reading);

  /// The child of the only edge. Throws std::runtime_error, naming the bag, where there is none or
  /// more than one.
  [[nodiscard]] std::string base_frame(const std::string& bag) const;

  /// Puts the readings of the only edge where they came among the other frames: at one log time,
  /// too. Does nothing where there is no edge.
  void insert_into(Frames& frames) const;

 private:
  using Edge = std::pair<std::string, std::string>;
  std::map<Edge, std::vector<Reading>> edges_;
};

}  // namespace castaway::testbed
