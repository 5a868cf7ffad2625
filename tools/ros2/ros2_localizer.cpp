#include "tools/ros2/ros2_localizer.hpp"

#include <limits>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "tools/ros2/ros_qos.hpp"
#include "tools/run/localizer_failure.hpp"

namespace castaway::testbed {
namespace {

using localization::Estimate;
using localization::PopulationView;
using std::chrono::milliseconds;

constexpr milliseconds kLook(50);          // Between two looks whether the node is there.
constexpr int kSilent = 5;                 // [scans] Without an answer in a row.
constexpr std::chrono::seconds kAgain(1);  // Between two tries to wake a node that begins.

/// Time of the run at a stamp of the node.
Stamp run_time(const ros::Time& time) { return from_ros_time(time) - kBagEpoch; }

Eigen::Matrix3d planar_covariance(const std::array<double, 36>& covariance) {
  constexpr std::array<int, 3> kRows{0, 1, 5};  // x, y and the rotation about z.
  Eigen::Matrix3d planar;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      planar(row, column) = covariance[6 * kRows[row] + kRows[column]];
    }
  }
  return planar;
}

SE2 planar_pose(const ros::Transform& transform) {
  const ros::Vector3& t = transform.translation;
  return from_ros_pose({{t.x, t.y, t.z}, transform.rotation});
}

}  // namespace

Ros2Localizer::Ros2Localizer(const Ros2Config& config, const Greeting& greeting)
    : config_(config),
      participant_({config.domain, config.interface}),
      other_clocks_(participant_, config.domain),
      feed_(participant_, config, greeting),
      transforms_(participant_, full_topic(config.name_space, config.topics.tf),
                  ros_qos::kTransforms),
      poses_(participant_, full_topic(config.name_space, config.topics.pose), ros_qos::kUsual),
      clouds_(participant_, full_topic(config.name_space, config.topics.particles),
              ros_qos::kSensor) {
  if (!config.drive) return;
  commands_.emplace(participant_, full_topic(config.name_space, config.topics.command),
                    config.command_timeout_s);
}

void Ros2Localizer::initialize(const std::optional<localization::PoseWithCovariance>& start) {
  feed_.set_time({});
  if (!is_present_) wait_for_node();
  start_ = start;
  answer_ = {};
}

bool Ros2Localizer::is_there() const {
  const int answering =
      config_.answer == Ros2Answer::kTransform ? transforms_.publishers() : poses_.publishers();
  return answering > 0 && feed_.scan_subscribers() > 0;
}

void Ros2Localizer::wait_for_node() {
  const auto end = Clock::now() + localization::from_seconds(config_.start_timeout_s);
  while (!is_there() && Clock::now() < end) std::this_thread::sleep_for(kLook);
  is_present_ = is_there();
  if (is_present_) return;
  throw LocalizerFailure(
      fmt::format("did not come within {:g} s: in domain {} on interface '{}', {}",
                  config_.start_timeout_s, config_.domain, config_.interface, what_is_missing()));
}

std::string Ros2Localizer::what_is_missing() const {
  const std::string hint =
      config_.interface == "loopback"
          ? "; nodes must be local: ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST, in ROS 2 Humble "
            "ROS_LOCALHOST_ONLY=1"
          : "";
  if (feed_.scan_subscribers() == 0) {
    return "nobody subscribes to " + full_topic(config_.name_space, config_.topics.scan) + hint;
  }
  const bool by_transform = config_.answer == Ros2Answer::kTransform;
  return "nobody publishes " +
         full_topic(config_.name_space, by_transform ? config_.topics.tf : config_.topics.pose);
}

/// A node that went is not waited for.
void Ros2Localizer::watch_node() {
  const bool now = is_there();
  if (now == is_present_) return;
  is_present_ = now;
  news_.emplace_back(now ? "the node came back" : "the node went");
  if (!now) T_map_odom_.reset();
}

void Ros2Localizer::keep_pace(Stamp now) {
  if (config_.pace <= 0.0) return;
  if (!began_) began_ = {now, Clock::now()};
  const double due_s = localization::seconds(now - began_->first) / config_.pace;
  std::this_thread::sleep_until(began_->second + localization::from_seconds(due_s));
}

void Ros2Localizer::on_odometry(const Odometry& odometry) {
  keep_pace(odometry.stamp);
  T_odom_base_.add(odometry.stamp, odometry.T_odom_base);
  if (!has_answered_) early_.push_back(odometry);
  feed_.publish(odometry);
  now_ = odometry.stamp;
  if (commands_) commands_->hear(now_);
}

void Ros2Localizer::send(const LaserScan& scan) {
  if (start_) feed_.publish_initial_pose(*start_);
  start_.reset();
  feed_.publish(scan);
}

void Ros2Localizer::on_scan(const LaserScan& scan) {
  if (!scan.ranges.empty()) keep_pace(scan.beam_stamp(scan.ranges.size() - 1));
  hear();  // Late ones.
  watch_node();
  for (std::string& sentence : feed_.refused()) news_.push_back(std::move(sentence));
  if (feed_.scan_subscribers() > 0 && !feed_.is_heard(scan.lidar)) {  // It wants other lidars.
    feed_.publish(scan);
    return settle(scan);
  }
  count_.expect(scan.stamp);
  if (has_answered_) {
    send(scan);
    wait_for_answer();
  } else {
    wait_for_first_answer(scan);
  }
  settle(scan);
}

/// A node that begins may miss messages: they are repeated.
void Ros2Localizer::wait_for_first_answer(const LaserScan& scan) {
  const auto start = start_;
  const auto end = Clock::now() + localization::from_seconds(config_.start_timeout_s);
  send(scan);
  while (!hear_until(std::min(Clock::now() + kAgain, end))) {
    if (Clock::now() >= end) {
      throw LocalizerFailure(
          fmt::format("gave no estimate within {:g} s", config_.start_timeout_s));
    }
    feed_.repeat_time();
    for (const Odometry& odometry : early_) feed_.publish(odometry);
    start_ = start;
    send(scan);
  }
  has_answered_ = true;
  early_.clear();
}

/// A node that is silent for some scans is hardly waited for until it answers again.
void Ros2Localizer::wait_for_answer() {
  const bool was_silent = unanswered_ >= kSilent;
  if (config_.pace > 0.0 || !is_present_) {
    hear();
  } else {
    hear_until(Clock::now() + (was_silent ? kLook : localization::from_seconds(config_.timeout_s)));
  }
  if (config_.pace > 0.0) return;  // It may come until the next scan.
  unanswered_ = count_.answered() ? 0 : unanswered_ + 1;
  if (!count_.answered()) count_.give_up();
  if (!is_present_) return;
  if (was_silent && unanswered_ == 0) news_.emplace_back("the node answers again");
  if (!was_silent && unanswered_ == kSilent) news_.emplace_back("the node is silent");
}

/// True if the scan was answered.
bool Ros2Localizer::hear_until(Clock::time_point end) {
  while (true) {
    hear();
    if (count_.answered()) return true;
    const auto left = end - Clock::now();
    if (left <= Clock::duration::zero()) return false;
    if (!participant_.wait(std::min<std::chrono::nanoseconds>(left, kLook)) && is_present_) {
      watch_node();
      if (!is_present_) return false;
    }
  }
}

void Ros2Localizer::hear() {
  while (const auto message = transforms_.take()) take(*message);
  // A pose that was sent before its transform is there by now.
  while (const auto message = poses_.take()) take(*message);
  while (const auto message = clouds_.take()) take(*message);
  other_clocks_.drain();
}

void Ros2Localizer::take(const ros::TFMessage& message) {
  if (config_.answer != Ros2Answer::kTransform) return;
  for (const ros::TransformStamped& edge : message.transforms) {
    if (edge.header.frame_id != config_.frames.map || edge.child_frame_id != config_.frames.odom) {
      continue;
    }
    try {
      T_map_odom_ = planar_pose(edge.transform);
      count_.take(run_time(edge.header.stamp) - localization::from_seconds(config_.ahead_s));
    } catch (const std::runtime_error&) {
      ++bad_;
    }
  }
}

void Ros2Localizer::take(const ros::PoseWithCovarianceStamped& message) {
  const Stamp stamp = run_time(message.header.stamp) - localization::from_seconds(config_.ahead_s);
  try {
    const SE2 T_map_base = from_ros_pose(message.pose.pose);
    pose_ = message;
    if (config_.answer != Ros2Answer::kPose) return;
    const auto T_odom_base = T_odom_base_.at(stamp);
    if (T_odom_base) T_map_odom_ = T_map_base * T_odom_base->inverse();
    count_.take(stamp);
  } catch (const std::runtime_error&) {
    ++bad_;
  }
}

void Ros2Localizer::take(const ros::ParticleCloud& message) {
  try {
    std::vector<SE2> particles;
    for (const ros::Particle& particle : message.particles) {
      particles.push_back(from_ros_pose(particle.pose));
    }
    particles_ = std::move(particles);
  } catch (const std::runtime_error&) {
    ++bad_;
  }
}

/// Where the newest transform says that the robot is: as others that read /tf would have it.
void Ros2Localizer::settle(const LaserScan& scan) {
  answer_ = {};
  const auto T_odom_base = T_odom_base_.at(scan.stamp);
  if (!T_map_odom_ || !T_odom_base) return;
  Estimate& estimate = answer_.estimate.emplace();
  estimate.stamp = scan.stamp;
  estimate.T_map_base = *T_map_odom_ * *T_odom_base;
  estimate.quality = estimate.probability = std::numeric_limits<double>::quiet_NaN();
  if (pose_) estimate.covariance = planar_covariance(pose_->pose.covariance);
  if (!particles_.empty()) {
    PopulationView& view = answer_.populations.emplace_back();
    view.T_map_base = estimate.T_map_base;
    view.share = 1.0;
    view.particles = particles_;
  }
  try {
    complete(answer_);
  } catch (const std::invalid_argument& error) {
    throw LocalizerFailure(error.what());
  }
}

localization::Diagnostics Ros2Localizer::diagnostics() const {
  localization::Diagnostics diagnostics;
  diagnostics.populations = answer_.populations;
  return diagnostics;
}

std::map<std::string, std::int64_t> Ros2Localizer::counts() const {
  auto counts = count_.counts();
  counts["malformed"] = (commands_ ? commands_->malformed() : 0) + bad_ + transforms_.malformed() +
                        poses_.malformed() + clouds_.malformed();
  return counts;
}

}  // namespace castaway::testbed
