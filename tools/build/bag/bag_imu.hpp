/// Readings of an inertial measurement unit in a bag.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "tools/build/bag/bag_mounts.hpp"
#include "tools/build/recorded/recorded_source.hpp"
#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed {

/// Appends readings to the frames of a bag, then turns them into base once the tree is known. The
/// lever arm of a unit that is mounted away from base is left out: it measures centripetal
/// accelerations that base does not have, while the robot turns.
class BagImu {
 public:
  /// Appends a frame with a reading of these axes. Readings that lack turn rates or accelerations
  /// (REP-145: the first element of the covariance is -1; or values that are not finite) are
  /// counted and left out.
  void take(const ros::Imu& imu, Stamp stamp, Stamp logged, Frames& frames);

  /// Turns the readings that it appended, before `frames` change otherwise. Returns warnings: of
  /// readings that were left out, and of frames that the tree does not connect to base, whose axes
  /// are taken as those of base.
  std::vector<std::string> turn_into_base(const BagMounts& mounts, Frames& frames) const;

 private:
  std::vector<std::pair<std::size_t, std::string>> readings_;  ///< Index, and frame of the axes.
  std::size_t incomplete_ = 0;
};

}  // namespace castaway::testbed
