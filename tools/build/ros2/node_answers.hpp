/// What a localizer of ROS 2 publishes.
#pragma once

#include <optional>
#include <vector>

#include "localization/geometry/transform_buffer.hpp"
#include "tools/build/foreign/answer.hpp"
#include "tools/build/ros2/answer_count.hpp"
#include "tools/build/ros2/ros_topic.hpp"
#include "tools/ros/ros_sensor.hpp"
#include "tools/ros/ros_wire.hpp"
#include "tools/run/ros2_config.hpp"

namespace castaway::testbed {

/// Takes transforms or poses, and particles, and says what they mean for a scan.
class NodeAnswers {
 public:
  NodeAnswers(DdsParticipant& participant, const Ros2Config& config);

  /// Takes what has come. `T_odom_base`: of the robot, at past stamps.
  void hear(const localization::TransformBuffer& T_odom_base, AnswerCount& count);
  /// The node went: its transform is not continued.
  void forget_transform() { T_map_odom_.reset(); }

  /// Where the newest transform says that the robot is, as others that read /tf would have it.
  /// Empty if nobody knows. Throws LocalizerFailure for what is no estimate.
  [[nodiscard]] Answer at(localization::Stamp stamp,
                          const localization::TransformBuffer& T_odom_base) const;

  /// Nodes that publish what is waited for.
  [[nodiscard]] int publishers() const;
  [[nodiscard]] int malformed() const;

 private:
  void take(const ros::TFMessage& message, AnswerCount& count);
  void take(const ros::PoseWithCovarianceStamped& message,
            const localization::TransformBuffer& T_odom_base, AnswerCount& count);
  void take(const ros::ParticleCloud& message);

  Ros2Config config_;
  RosSubscription<ros::TFMessage> transforms_;
  RosSubscription<ros::PoseWithCovarianceStamped> poses_;
  RosSubscription<ros::ParticleCloud> clouds_;
  std::optional<localization::SE2> T_map_odom_;
  std::optional<ros::PoseWithCovarianceStamped> pose_;  ///< The newest one.
  std::vector<localization::SE2> particles_;
  int bad_ = 0;  ///< Answers that are no poses.
};

}  // namespace castaway::testbed
