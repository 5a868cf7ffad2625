#include "tools/build/ros2/node_answers.hpp"

#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include "tools/build/ros2/ros_qos.hpp"
#include "tools/ros/bag_frames.hpp"
#include "tools/ros/ros_conversion.hpp"
#include "tools/run/localizer_failure.hpp"

namespace castaway::testbed {
namespace {

using localization::Estimate;
using localization::PopulationView;
using localization::SE2;
using localization::Stamp;

/// Time of the run at a stamp of the node.
Stamp run_time(const ros::Time& time) { return from_ros_time(time) - kBagEpoch; }

Eigen::Matrix3d planar_covariance(const std::array<double, 36>& covariance) {
  const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> whole(covariance.data());
  const std::array<int, 3> kept{0, 1, 5};  // x, y and the rotation about z.
  return whole(kept, kept);
}

SE2 planar_pose(const ros::Transform& transform) {
  const ros::Vector3& t = transform.translation;
  return from_ros_pose({{t.x, t.y, t.z}, transform.rotation});
}

}  // namespace

NodeAnswers::NodeAnswers(DdsParticipant& participant, const Ros2Config& config)
    : config_(config),
      transforms_(participant, full_topic(config.name_space, config.topics.tf),
                  ros_qos::kTransforms),
      poses_(participant, full_topic(config.name_space, config.topics.pose), ros_qos::kUsual),
      clouds_(participant, full_topic(config.name_space, config.topics.particles),
              ros_qos::kSensor) {}

void NodeAnswers::hear(const localization::TransformBuffer& T_odom_base, AnswerCount& count) {
  while (const auto message = transforms_.take()) take(*message, count);
  // A pose that was sent before its transform is there by now.
  while (const auto message = poses_.take()) take(*message, T_odom_base, count);
  while (const auto message = clouds_.take()) take(*message);
}

void NodeAnswers::take(const ros::TFMessage& message, AnswerCount& count) {
  if (config_.answer != Ros2Answer::kTransform) return;
  for (const ros::TransformStamped& edge : message.transforms) {
    if (edge.header.frame_id != config_.frames.map || edge.child_frame_id != config_.frames.odom) {
      continue;
    }
    try {
      T_map_odom_ = planar_pose(edge.transform);
      count.take(run_time(edge.header.stamp) - localization::from_seconds(config_.ahead_s));
    } catch (const std::runtime_error&) {
      ++bad_;
    }
  }
}

void NodeAnswers::take(const ros::PoseWithCovarianceStamped& message,
                       const localization::TransformBuffer& T_odom_base, AnswerCount& count) {
  const Stamp stamp = run_time(message.header.stamp) - localization::from_seconds(config_.ahead_s);
  try {
    const SE2 T_map_base = from_ros_pose(message.pose.pose);
    pose_ = message;
    if (config_.answer != Ros2Answer::kPose) return;
    const auto T_odom_then = T_odom_base.at(stamp);
    if (T_odom_then) T_map_odom_ = T_map_base * T_odom_then->inverse();
    count.take(stamp);
  } catch (const std::runtime_error&) {
    ++bad_;
  }
}

void NodeAnswers::take(const ros::ParticleCloud& message) {
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

Answer NodeAnswers::at(localization::Stamp stamp,
                       const localization::TransformBuffer& T_odom_base) const {
  Answer answer;
  const auto T_odom_then = T_odom_base.at(stamp);
  if (!T_map_odom_ || !T_odom_then) return answer;
  Estimate& estimate = answer.estimate.emplace();
  estimate.stamp = stamp;
  estimate.T_map_base = *T_map_odom_ * *T_odom_then;
  estimate.quality = estimate.probability = std::numeric_limits<double>::quiet_NaN();
  if (pose_) estimate.covariance = planar_covariance(pose_->pose.covariance);
  if (!particles_.empty()) {
    PopulationView& view = answer.populations.emplace_back();
    view.T_map_base = estimate.T_map_base;
    view.share = 1.0;
    view.particles = particles_;
  }
  try {
    complete(answer);
  } catch (const std::invalid_argument& error) {
    throw LocalizerFailure(error.what());
  }
  return answer;
}

int NodeAnswers::publishers() const {
  return config_.answer == Ros2Answer::kTransform ? transforms_.publishers() : poses_.publishers();
}

int NodeAnswers::malformed() const {
  return bad_ + transforms_.malformed() + poses_.malformed() + clouds_.malformed();
}

}  // namespace castaway::testbed
