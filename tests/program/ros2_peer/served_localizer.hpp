/// mh_amcl behind the topics of ROS 2, as a node on the other side would run it.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "localization/mh_amcl/mh_amcl.hpp"
#include "tests/program/ros2_peer/wire.hpp"

namespace castaway::peer {

/// How the node behaves, well or badly.
struct Manners {
  bool known_start = true;  ///< Waits for /initialpose before the first scan.
  std::string scan_topic = "rt/scan";
  int answer_every = 1;        ///< Answers only one scan in so many.
  bool twice = false;          ///< Sends every answer twice.
  int late_ms = 0;             ///< Waits so long before every tenth answer.
  std::int64_t ahead_ns = 0;   ///< Added to the stamps of transforms.
  bool garbage = false;        ///< Sends malformed messages, too.
  std::string drive;           ///< "plain" or "stamped" commands to drive in a circle.
  bool with_transform = true;  ///< Answers on /tf.
  bool stays = false;          ///< Waits for another simulator, and begins anew with its map.
};

/// What came over the wire so far.
struct Received {
  std::map<std::string, int> messages;                   ///< By topic.
  std::map<std::string, std::set<std::int64_t>> stamps;  ///< [ns] Of odometry and scans.
  std::string description;
  std::string frames;  ///< "parent>child" of /tf_static and /tf, each once.
};

/// The node.
class ServedLocalizer {
 public:
  ServedLocalizer(Wire& wire, std::uint64_t seed, Manners manners);

  /// Takes what has come, and answers. Returns true if there was anything.
  bool turn();
  /// True once a simulator was there and has gone.
  bool is_over();
  [[nodiscard]] const Received& received() const { return received_; }

 private:
  void take_map();
  void begin(const OccupancyGrid& map);
  void take_frames();
  bool take_sensors();
  bool ready_for(const LaserScan& scan) const;
  void handle(const LaserScan& scan);
  void answer(const LaserScan& scan);
  void drive(const Header& header);
  void send(const localization::Estimate& estimate, const LaserScan& scan);

  Manners manners_;
  std::uint64_t seed_;
  dds::DataReader* clock_;
  dds::DataReader* scan_;
  dds::DataReader* odom_;
  dds::DataReader* tf_;
  dds::DataReader* tf_static_;
  dds::DataReader* map_;
  dds::DataReader* start_;
  dds::DataReader* description_;
  dds::DataWriter* answers_;
  dds::DataWriter* poses_;
  dds::DataWriter* garbage_;
  dds::DataWriter* commands_ = nullptr;
  dds::DataWriter* clouds_;
  Received received_;
  std::unique_ptr<localization::MhAmcl> localizer_;
  std::map<std::string, Eigen::Isometry3d> T_parent_frame_;
  std::map<std::string, std::string> parent_;
  std::optional<localization::PoseWithCovariance> initial_pose_;
  bool is_started_ = false;
  bool had_simulator_ = false;
  std::deque<LaserScan> scans_;
  std::deque<localization::Odometry> odometry_;
  std::int64_t newest_odometry_ns_ = -1;
  std::int64_t period_ns_ = 0;
  localization::TransformBuffer T_odom_base_;
  std::int64_t newest_scan_ns_ = -1;
  std::optional<OccupancyGrid> newest_map_;
  int scan_count_ = 0;
  std::int64_t answered_ns_ = -1;  ///< Stamp of the last scan that was to be answered.
};

}  // namespace castaway::peer
