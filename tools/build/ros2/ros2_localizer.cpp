#include "tools/build/ros2/ros2_localizer.hpp"

#include <cmath>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "tools/build/ros2/ros_qos.hpp"
#include "tools/run/localizer_failure.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kLook(50);          // Between two looks whether the node is there.
constexpr int kSilent = 5;                 // [scans] Without an answer in a row.
constexpr std::chrono::seconds kAgain(1);  // Between two tries to wake a node that begins.

}  // namespace

VelocityCommands::VelocityCommands(DdsParticipant& participant, const std::string& topic,
                                   double timeout_s)
    : timeout_(localization::from_seconds(timeout_s)),
      plain_(participant, topic, ros_qos::kUsual),
      stamped_(participant, topic, ros_qos::kUsual) {}

void VelocityCommands::take(const ros::Twist& twist, Stamp now) {
  if (!std::isfinite(twist.linear.x) || !std::isfinite(twist.angular.z)) {
    ++bad_;
    return;
  }
  newest_ = {twist.linear.x, twist.angular.z};
  came_ = now;
}

void VelocityCommands::hear(Stamp now) {
  while (const auto message = plain_.take()) take(*message, now);
  while (const auto message = stamped_.take()) take(message->twist, now);
}

BaseVelocity VelocityCommands::at(Stamp now) const {
  return came_ >= Stamp{} && now - came_ <= timeout_ ? newest_ : BaseVelocity{};
}

Ros2Localizer::Ros2Localizer(const Ros2Config& config, const Greeting& greeting)
    : config_(config),
      participant_({config.domain, config.interface}),
      other_clocks_(participant_, config.domain),
      feed_(participant_, config, greeting),
      answers_(participant_, config),
      pacer_(config.pace) {
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
  return answers_.publishers() > 0 && feed_.scan_subscribers() > 0;
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
  if (!now) answers_.forget_transform();
}

void Ros2Localizer::on_odometry(const Odometry& odometry) {
  pacer_.wait_until(odometry.stamp);
  T_odom_base_.add(odometry.stamp, odometry.T_odom_base);
  if (!has_answered_) early_.emplace_back(odometry);
  feed_.publish(odometry);
  now_ = odometry.stamp;
  if (commands_) commands_->hear(now_);
}

void Ros2Localizer::on_imu(const localization::Imu& imu) {
  pacer_.wait_until(imu.stamp);
  if (!has_answered_) early_.emplace_back(imu);
  feed_.publish(imu);
}

void Ros2Localizer::send(const LaserScan& scan) {
  if (start_) feed_.publish_initial_pose(*start_);
  start_.reset();
  feed_.publish(scan);
}

void Ros2Localizer::on_scan(const LaserScan& scan) {
  if (!scan.ranges.empty()) pacer_.wait_until(scan.beam_stamp(scan.ranges.size() - 1));
  hear();  // Late ones.
  watch_node();
  for (std::string& sentence : feed_.refused()) news_.push_back(std::move(sentence));
  if (feed_.scan_subscribers() > 0 && !feed_.is_heard(scan.lidar)) {  // It wants other lidars.
    feed_.publish(scan);
    answer_ = answers_.at(scan.stamp, T_odom_base_);
    return;
  }
  count_.expect(scan.stamp);
  if (has_answered_) {
    send(scan);
    wait_for_answer();
  } else {
    wait_for_first_answer(scan);
  }
  answer_ = answers_.at(scan.stamp, T_odom_base_);
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
    for (const auto& reading : early_) {
      std::visit([&](const auto& early) { feed_.publish(early); }, reading);
    }
    start_ = start;
    count_.repeat();
    send(scan);
  }
  has_answered_ = true;
  early_.clear();
}

/// A node that is silent for some scans is hardly waited for until it answers again.
void Ros2Localizer::wait_for_answer() {
  const bool was_silent = unanswered_ >= kSilent;
  if (pacer_.is_on() || !is_present_) {
    hear();
  } else {
    hear_until(Clock::now() + (was_silent ? kLook : localization::from_seconds(config_.timeout_s)));
  }
  if (pacer_.is_on()) return;  // It may come until the next scan.
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
  answers_.hear(T_odom_base_, count_);
  other_clocks_.drain();
}

localization::Diagnostics Ros2Localizer::diagnostics() const {
  localization::Diagnostics diagnostics;
  diagnostics.populations = answer_.populations;
  return diagnostics;
}

std::map<std::string, std::int64_t> Ros2Localizer::counts() const {
  auto counts = count_.counts();
  counts["malformed"] = answers_.malformed() + (commands_ ? commands_->malformed() : 0);
  return counts;
}

}  // namespace castaway::testbed
