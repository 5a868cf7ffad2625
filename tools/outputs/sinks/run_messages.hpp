/// A run as messages of ROS 2: docs/formats.md.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "localization/geometry/transform_buffer.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/ros/bag_channels.hpp"
#include "tools/ros/bag_drive.hpp"
#include "tools/ros/bag_frames.hpp"
#include "tools/ros/topic_writer.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// What messages need besides the data of the run.
struct MessagesConfig {
  std::map<std::string, Eigen::Isometry3d> links{};  ///< T_base_link of the robot's links.
  std::vector<BagLidar> lidars{};
  bool particles = true;              ///< All particles of all localizers.
  std::function<DriveNow()> drive{};  ///< Command and wheel states; empty: unknown.
  bool points = true;                 ///< All layers of 3-D lidars.
  bool clouds = false;                ///< Scans and particles as clouds, too.
};

/// Writes what happens to a writer of topics.
class RunMessages {
 public:
  /// Adds the topics. `writer` must outlive this.
  RunMessages(const RunInfo& info, MessagesConfig config, TopicWriter& writer);

  /// The map and the fixed frames.
  void begin(const RosMap& map);
  void on_event(const RunEvent& event);
  void on_odometry(const OdometryFrame& frame);
  void on_scan(const ScanRecord& record);
  /// Adds the topic /imu with the first reading.
  void on_imu(const ImuFrame& frame);
  /// Of what beams hit so far.
  [[nodiscard]] const std::set<int>& labels() const { return labels_; }

 private:
  /// Topics of a lidar.
  struct LidarTopics {
    std::uint16_t scan = 0;
    std::uint16_t labels = 0;
    std::uint16_t points = 0;  ///< Of 3-D lidars.
    std::uint16_t cloud = 0;   ///< Only with `MessagesConfig::clouds`.
  };
  const LidarTopics& topics_of(const LaserScan& scan);
  [[nodiscard]] bool has_points(const LaserScan& scan) const;
  void write_scan(const ScanRecord& record);
  void write_truth(const ScanRecord& record);
  void write_map_frame(const ScanRecord& record);
  void write_drive(Stamp stamp, double dt_s);
  void write_localizer(const ScanRecord& record, std::size_t index);

  MessagesConfig config_;
  TopicWriter& writer_;
  BagFrames frames_;
  BagChannels channels_;
  bool heights_;  ///< Poses have a height.
  std::map<std::string, LidarTopics> lidars_;
  localization::TransformBuffer T_odom_base_;
  std::optional<std::uint16_t> imu_;  ///< Topic; nothing before the first reading.
  std::optional<OdometryFrame> last_;
  std::set<int> labels_;
  std::optional<DriveNow> drive_;  ///< At the newest odometry.
};

}  // namespace castaway::testbed
