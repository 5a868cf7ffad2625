/// Odometry from an edge of /tf.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/build/recorded/recorded_source.hpp"

namespace castaway::testbed {

/// Collects the edges that may be odometry, until one is chosen.
class TfOdometry {
 public:
  /// A transform from an odometry frame to its child.
  struct Reading {
    Stamp logged{};
    Stamp stamp{};
    SE2 T_odom_base;
    std::size_t before = 0;  ///< Index of the frame that follows it in the bag.
  };

  void add(const std::string& parent, const std::string& child, const Reading& reading);

  /// Child frame of the only edge. Throws std::runtime_error, naming the bag, unless there is
  /// exactly one edge.
  [[nodiscard]] std::string base_frame(const std::string& bag) const;

  /// Inserts the readings of the only edge among the other frames in the order of the bag, also at
  /// equal log times. Does nothing if there is no edge.
  void insert_into(Frames& frames) const;

 private:
  using Edge = std::pair<std::string, std::string>;
  std::map<Edge, std::vector<Reading>> edges_;
};

}  // namespace castaway::testbed
