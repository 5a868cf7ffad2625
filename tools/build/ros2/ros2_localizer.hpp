/// A localizer that is a node of ROS 2: docs/ros2.md.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "localization/geometry/transform_buffer.hpp"
#include "tools/build/ros2/node_answers.hpp"
#include "tools/build/ros2/other_clocks.hpp"
#include "tools/build/ros2/pacer.hpp"
#include "tools/build/ros2/robot_feed.hpp"
#include "tools/build/ros2/ros_topic.hpp"
#include "tools/ros/ros_geometry.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Takes geometry_msgs/Twist and TwistStamped, of which Nav2 sends one, by its version.
class VelocityCommands {
 public:
  VelocityCommands(DdsParticipant& participant, const std::string& topic, double timeout_s);

  /// Takes what came until `now`, simulated time.
  void hear(Stamp now);
  /// The newest command; standstill if there was none for long.
  [[nodiscard]] BaseVelocity at(Stamp now) const;
  [[nodiscard]] int malformed() const { return plain_.malformed() + stamped_.malformed() + bad_; }

 private:
  void take(const ros::Twist& twist, Stamp now);

  Stamp timeout_;
  RosSubscription<ros::Twist> plain_;
  RosSubscription<ros::TwistStamped> stamped_;
  BaseVelocity newest_;
  Stamp came_{-1};
  int bad_ = 0;  ///< Those that hold no numbers.
};

/// Publishes what a robot does and takes the node's estimate. In lock step, it waits for the answer
/// to every scan. What ends the conversation is thrown as LocalizerFailure.
class Ros2Localizer final : public localization::Localizer {
 public:
  /// Takes part in the domain. Throws std::runtime_error if it cannot, or if someone else publishes
  /// simulated time there.
  Ros2Localizer(const Ros2Config& config, const Greeting& greeting);

  /// An unknown start is not told. The first call waits for the node.
  void initialize(const std::optional<localization::PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_imu(const localization::Imu& imu) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<localization::Estimate> estimate() const override {
    return answer_.estimate;
  }
  [[nodiscard]] localization::Diagnostics diagnostics() const override;

  /// The node's command at the newest odometry; only if it drives.
  [[nodiscard]] BaseVelocity velocity() const { return commands_->at(now_); }
  [[nodiscard]] bool drives() const { return commands_.has_value(); }
  /// What became of the scans, `AnswerCount::counts`, and messages that were "malformed".
  [[nodiscard]] std::map<std::string, std::int64_t> counts() const;
  /// What happened on the wire since the last call, in one sentence each.
  std::vector<std::string> take_news() { return std::exchange(news_, {}); }

 private:
  using Clock = std::chrono::steady_clock;

  void wait_for_node();
  [[nodiscard]] bool is_there() const;
  [[nodiscard]] std::string what_is_missing() const;
  void watch_node();
  void send(const LaserScan& scan);
  void wait_for_first_answer(const LaserScan& scan);
  void wait_for_answer();
  bool hear_until(Clock::time_point end);
  void hear();

  Ros2Config config_;
  DdsParticipant participant_;
  OtherClocks other_clocks_;
  RobotFeed feed_;
  NodeAnswers answers_;
  std::optional<VelocityCommands> commands_;  ///< Nothing: it does not drive.
  Stamp now_{};                               ///< Of the newest odometry.
  AnswerCount count_;
  int unanswered_ = 0;  ///< Scans in a row.
  bool is_present_ = false;
  bool has_answered_ = false;
  std::vector<std::variant<Odometry, localization::Imu>> early_;  ///< Before the first answer.
  std::optional<localization::PoseWithCovariance> start_;  ///< To be told with the next scan.
  localization::TransformBuffer T_odom_base_;
  Answer answer_;
  std::vector<std::string> news_;
  Pacer pacer_;
};

}  // namespace castaway::testbed
