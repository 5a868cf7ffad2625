#include "tools/outputs/sinks/bag_sink.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/ros/event_json.hpp"
#include "tools/ros/ros_visualization.hpp"
#include "tools/ros/storage/mcap_reader.hpp"

namespace castaway::testbed {
namespace {

RosMap map() { return {"m", 2, 2, 0.05, 0.0, 0.0, 0.0, {0, 100, -1, 0}}; }

BagConfig config() {
  BagConfig config;
  config.links["base_link"] = Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.1));
  config.lidars = {{"lidar", "laser", Eigen::Isometry3d(Eigen::Translation3d(0.1, 0.0, 0.3))}};
  config.scenario_yaml = "seed: 7\n";
  config.start = SE2{1.0, 2.0, 0.5};
  config.label_name = [](int label) { return "thing " + std::to_string(label); };
  return config;
}

OdometryFrame odometry_at(double t) {
  return {{localization::from_seconds(t), {0.5 * t, 0.0, 0.0}}, SE2{0.1 * t, 0.0, 0.0}};
}

ScanRecord scan_at(double t) {
  ScanRecord record = record_at(t, {"mh_amcl", "amcl-2"});
  record.scan.stamp = record.stamp;
  record.scan.lidar = "lidar";
  record.scan.angle_increment = 0.1;
  record.scan.range_max = 8.0;
  record.scan.ranges = {1.0F, 2.0F, 3.0F};
  record.scan.T_base_laser = Eigen::Translation3d(0.1, 0.0, 0.3);
  record.truth.labels = {4, -1, 4};
  record.people.people = {{3, {1.0, 1.0, 0.0}, {0.0, 0.0}, 2.0}};
  auto& populations = record.localizers[0].diagnostics.populations;
  populations.push_back({5, {0.0, 0.2, 0.1}, 0.7, 0.9, true, {{0.0, 0.2, 0.1}, {0.0, 0.3, 0.1}}});
  return record;
}

/// Plays one second with a kidnap.
void play(BagSink& sink) {
  for (int i = 0; i <= 10; ++i) {
    const double t = 0.1 * i;
    if (i == 6) sink.on_event(kidnap_to(t));
    sink.on_odometry(odometry_at(t));
    if (i == 5 || i == 10) sink.on_scan(scan_at(t - 0.1));
  }
  sink.finish({}, {});
}

/// All decoded messages of a topic, and the number of messages per topic.
template <typename Message>
std::vector<Message> messages_of(const std::filesystem::path& folder, const std::string& topic) {
  McapReader reader(folder / "bag" / "a_scenario.mcap");
  std::vector<Message> messages;
  while (const auto message = reader.next()) {
    if (message->channel->topic != topic) continue;
    EXPECT_EQ(reader.schema_of(*message->channel)->name, Message::kType);
    messages.push_back(CdrReader::decode<Message>(message->data));
  }
  return messages;
}

class BagSinkTest : public testing::Test {
 protected:
  /// Writes a bag of the run above to `folder()`.
  void write(BagConfig with) {
    BagSink sink(folder_.path(), run_of({"mh_amcl", "amcl-2"}), map(), std::move(with));
    play(sink);
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

TEST_F(BagSinkTest, TellsTimeInOrderFromASecondOn) {
  write(config());
  McapReader reader(folder() / "bag" / "a_scenario.mcap");
  std::int64_t newest = 1'000'000'000;
  int count = 0;
  while (const auto message = reader.next()) {
    EXPECT_GE(message->log_time_ns, newest);
    newest = message->log_time_ns;
    ++count;
  }
  EXPECT_EQ(newest, 2'000'000'000);
  const std::string metadata = read_file(folder() / "bag" / "metadata.yaml");
  EXPECT_TRUE(contains(metadata, "message_count: " + std::to_string(count) + "\n"));
  EXPECT_TRUE(contains(metadata, "nanoseconds_since_epoch: 1000000000\n"));
  EXPECT_FALSE(reader.warning());
}

TEST_F(BagSinkTest, WritesScansWithTheirTruthAndLabels) {
  write(config());
  const auto scans = messages_of<ros::LaserScan>(folder(), "/scan");
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].header.frame_id, "laser");
  EXPECT_EQ(scans[0].header.stamp.sec, 1);
  EXPECT_EQ(scans[0].header.stamp.nanosec, 400'000'000U);
  EXPECT_EQ(scans[0].ranges, (std::vector<float>{1.0F, 2.0F, 3.0F}));
  const auto poses = messages_of<ros::PoseStamped>(folder(), "/ground_truth/scan_pose");
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_NEAR(poses[1].pose.position.x, 0.09, 1e-12);
  EXPECT_EQ(poses[1].header.frame_id, "map");
  const auto labels = messages_of<ros::Int32MultiArray>(folder(), "/scan_labels");
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].data, (std::vector<std::int32_t>{4, -1, 4}));
  EXPECT_EQ(labels[0].layout.dim.at(0).size, 3U);
}

TEST_F(BagSinkTest, WritesOdometryWithVelocityAndTruthOutsideTheTree) {
  write(config());
  const auto odometry = messages_of<ros::Odometry>(folder(), "/odom");
  ASSERT_EQ(odometry.size(), 11U);
  EXPECT_EQ(odometry[4].header.frame_id, "odom");
  EXPECT_EQ(odometry[4].child_frame_id, "base_footprint");
  EXPECT_NEAR(odometry[4].pose.pose.position.x, 0.2, 1e-12);
  EXPECT_NEAR(odometry[4].twist.twist.linear.x, 0.5, 1e-9);
  const auto truth = messages_of<ros::Odometry>(folder(), "/ground_truth/odom");
  ASSERT_EQ(truth.size(), 11U);
  EXPECT_EQ(truth[4].header.frame_id, "map");
  EXPECT_NEAR(truth[4].twist.twist.linear.x, 0.1, 1e-9);
  for (const auto& message : messages_of<ros::TFMessage>(folder(), "/tf")) {
    for (const auto& edge : message.transforms) {
      EXPECT_TRUE(edge.header.frame_id == "odom" ||
                  (edge.header.frame_id == "map" && edge.child_frame_id == "odom"));
    }
  }
}

TEST_F(BagSinkTest, PutsTheFirstLocalizerIntoTheTree) {
  write(config());
  std::vector<ros::TransformStamped> edges;
  for (const auto& message : messages_of<ros::TFMessage>(folder(), "/tf")) {
    if (message.transforms.at(0).header.frame_id == "map") edges.push_back(message.transforms[0]);
  }
  ASSERT_EQ(edges.size(), 2U);
  // At 0.4 s: T_map_base = (0.04, 0.2, 0.1), T_odom_base = (0.2, 0, 0).
  EXPECT_NEAR(edges[0].transform.translation.x, 0.04 - 0.2 * std::cos(0.1), 1e-12);
  EXPECT_NEAR(edges[0].transform.translation.y, 0.2 - 0.2 * std::sin(0.1), 1e-12);
  EXPECT_EQ(edges[0].header.stamp.nanosec, 400'000'000U);
}

TEST_F(BagSinkTest, WritesScansAndParticlesAsCloudsOnRequest) {
  write(config());
  EXPECT_TRUE(messages_of<ros::PointCloud2>(folder(), "/scan_points").empty());
  EXPECT_TRUE(messages_of<ros::PointCloud2>(folder(), "/mh_amcl/particle_points").empty());
  BagConfig with = config();
  with.options.clouds = true;
  std::filesystem::remove_all(folder() / "bag");
  write(with);
  const auto scans = messages_of<ros::PointCloud2>(folder(), "/scan_points");
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].header.frame_id, "laser");
  EXPECT_EQ(scans[0].width, 3U);
  const auto particles = messages_of<ros::PointCloud2>(folder(), "/mh_amcl/particle_points");
  ASSERT_EQ(particles.size(), 2U);
  EXPECT_EQ(particles[0].header.frame_id, "map");
  EXPECT_EQ(particles[0].header.stamp.nanosec, 400'000'000U);
  EXPECT_EQ(particles[0].width, 2U);
  EXPECT_EQ(messages_of<ros::PointCloud2>(folder(), "/amcl_2/particle_points").at(1).width, 0U);
  EXPECT_TRUE(messages_of<ros::PoseArray>(folder(), "/mh_amcl/particlecloud").empty());
}

/// 3.5 m up, nose up.
Eigen::Isometry3d on_ramp() {
  return Eigen::Translation3d(0.0, 0.0, 3.5) * Eigen::AngleAxisd(-0.1, Eigen::Vector3d::UnitY());
}

/// A quaternion as a rotation.
Eigen::Matrix3d rotation_of(const ros::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}

/// Plays an odometry reading and a scan of a run on several floors.
void play_on_ramp(BagSink& sink) {
  OdometryFrame odometry = odometry_at(0.5);
  odometry.true_pose->T_footprint_base = on_ramp();
  sink.on_odometry(odometry);
  ScanRecord record = scan_at(0.5);
  record.true_pose->T_footprint_base = on_ramp();
  record.localizers[0].estimate->footing = localization::Footing{3.25, 1};
  record.localizers[0].diagnostics.populations[0].footing = localization::Footing{3.125, 1};
  sink.on_scan(record);
  sink.finish({}, {});
}

TEST(BagOfFloors, PosesHaveTheirHeight) {
  const TemporaryFolder folder;
  RunInfo info = run_of({"mh_amcl", "amcl-2"});
  info.heights = true;
  BagConfig with = config();
  with.options.particles = true;
  BagSink sink(folder.path(), info, map(), std::move(with));
  play_on_ramp(sink);
  const auto truth = messages_of<ros::Odometry>(folder.path(), "/ground_truth/odom").at(0);
  EXPECT_EQ(truth.pose.pose.position.z, 3.5);
  EXPECT_TRUE(rotation_of(truth.pose.pose.orientation).isApprox(on_ramp().linear(), 1e-12));
  const auto scan = messages_of<ros::PoseStamped>(folder.path(), "/ground_truth/scan_pose").at(0);
  EXPECT_EQ(scan.pose.position.z, 3.5);
  EXPECT_TRUE(rotation_of(scan.pose.orientation).isApprox(on_ramp().linear(), 1e-12));
  using Pose = ros::PoseWithCovarianceStamped;
  const auto height_of = [&](const std::string& topic) {
    return messages_of<Pose>(folder.path(), topic).at(0).pose.pose.position.z;
  };
  EXPECT_EQ(height_of("/mh_amcl/amcl_pose"), 3.25);
  EXPECT_EQ(height_of("/amcl_2/amcl_pose"), 0.0);  // A planar localizer.
  EXPECT_EQ(messages_of<ros::Odometry>(folder.path(), "/odom").at(0).pose.pose.position.z, 0.0);
  const auto edges = messages_of<ros::TFMessage>(folder.path(), "/tf");
  EXPECT_EQ(edges.at(1).transforms.at(0).child_frame_id, "odom");
  EXPECT_EQ(edges.at(1).transforms.at(0).transform.translation.z, 3.25);
  const auto particles = messages_of<ros::PoseArray>(folder.path(), "/mh_amcl/particlecloud");
  EXPECT_EQ(particles.at(0).poses.at(1).position.z, 3.125);
  const auto arrows = messages_of<ros::MarkerArray>(folder.path(), "/mh_amcl/hypotheses");
  EXPECT_EQ(arrows.at(0).markers.at(1).pose.position.z, 3.125);
}

TEST(BagOfFloors, OnOneFloorAStatedHeightIsLeftOut) {
  const TemporaryFolder folder;
  BagSink sink(folder.path(), run_of({"mh_amcl", "amcl-2"}), map(), config());
  ScanRecord record = scan_at(0.5);
  record.localizers[0].estimate->footing = localization::Footing{0.01, 0};
  sink.on_scan(record);
  sink.finish({}, {});
  const auto poses =
      messages_of<ros::PoseWithCovarianceStamped>(folder.path(), "/mh_amcl/amcl_pose");
  EXPECT_EQ(poses.at(0).pose.pose.position.z, 0.0);
}

TEST(BagOfImu, HasItsReadingsWithoutAnOrientation) {
  const TemporaryFolder folder;
  BagSink sink(folder.path(), run_of({}), map(), config());
  localization::Imu imu{std::chrono::milliseconds(250), {0.1, -0.2, 0.3}, {0.5, 0.25, 9.75}};
  sink.on_imu({imu});
  sink.finish({}, {});
  const auto readings = messages_of<ros::Imu>(folder.path(), "/imu");
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_EQ(readings[0].header.frame_id, "base_footprint");
  EXPECT_EQ(readings[0].header.stamp.nanosec, 250'000'000U);
  EXPECT_EQ(readings[0].orientation_covariance[0], -1.0);
  EXPECT_EQ(readings[0].angular_velocity.y, -0.2);
  EXPECT_EQ(readings[0].linear_acceleration.z, 9.75);
}

TEST_F(BagSinkTest, TellsFixedFramesAndTheirChanges) {
  BagConfig stated = config();
  stated.lidars[0].T_base_laser = Eigen::Translation3d(0.0, 0.0, 0.3);
  write(stated);
  const auto frames = messages_of<ros::TFMessage>(folder(), "/tf_static");
  ASSERT_EQ(frames.size(), 2U);  // At the start, and at the first scan, whose mount differs.
  ASSERT_EQ(frames[1].transforms.size(), 2U);
  EXPECT_EQ(frames[1].transforms[0].header.frame_id, "base_footprint");
  EXPECT_EQ(frames[1].transforms[0].child_frame_id, "base_link");
  EXPECT_EQ(frames[1].transforms[1].header.frame_id, "base_link");
  EXPECT_EQ(frames[1].transforms[1].child_frame_id, "laser");
  EXPECT_NEAR(frames[1].transforms[1].transform.translation.x, 0.1, 1e-12);
  EXPECT_NEAR(frames[1].transforms[1].transform.translation.z, 0.2, 1e-12);
}

TEST_F(BagSinkTest, WritesLocalizersInTheirNamespaces) {
  write(config());
  const auto poses = messages_of<ros::PoseWithCovarianceStamped>(folder(), "/amcl_2/amcl_pose");
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_NEAR(poses[0].pose.pose.position.y, 0.2, 1e-12);
  const auto markers = messages_of<ros::MarkerArray>(folder(), "/mh_amcl/hypotheses");
  ASSERT_EQ(markers.size(), 2U);
  ASSERT_EQ(markers[0].markers.size(), 2U);
  EXPECT_EQ(markers[0].markers[0].action, 3);
  EXPECT_EQ(markers[0].markers[1].id, 5);
  EXPECT_TRUE(messages_of<ros::PoseArray>(folder(), "/mh_amcl/particlecloud").empty());
}

TEST_F(BagSinkTest, WritesParticlesWhereAskedTo) {
  BagConfig all = config();
  all.options.particles = true;
  write(all);
  const auto clouds = messages_of<ros::PoseArray>(folder(), "/mh_amcl/particlecloud");
  ASSERT_EQ(clouds.size(), 2U);
  EXPECT_EQ(clouds[0].poses.size(), 2U);
  EXPECT_NEAR(clouds[0].poses[1].position.y, 0.3, 1e-12);
}

TEST_F(BagSinkTest, WritesPicturesWhereAskedTo) {
  BagConfig with = config();
  with.options.snapshots = true;
  std::filesystem::create_directories(folder() / "snapshots");
  std::ofstream(folder() / "snapshots" / "t0000.200-time-map.png") << "a picture";
  write(with);
  const auto pictures = messages_of<ros::CompressedImage>(folder(), "/snapshot/map");
  ASSERT_EQ(pictures.size(), 1U);
  EXPECT_EQ(pictures[0].format, "png");
  EXPECT_EQ(std::string(pictures[0].data.begin(), pictures[0].data.end()), "a picture");
  EXPECT_EQ(pictures[0].header.stamp.nanosec, 200'000'000U);
}

TEST_F(BagSinkTest, WritesPeopleEventsAndTheMap) {
  write(config());
  const auto people = messages_of<ros::MarkerArray>(folder(), "/people");
  ASSERT_EQ(people.size(), 2U);
  EXPECT_EQ(people[0].markers.at(0).id, 3);
  const auto events = messages_of<ros::String>(folder(), "/events");
  ASSERT_EQ(events.size(), 1U);
  EXPECT_TRUE(event_of_json(events[0].data)->is<KidnapEvent>());
  const auto maps = messages_of<ros::OccupancyGrid>(folder(), "/map");
  ASSERT_EQ(maps.size(), 1U);
  EXPECT_EQ(maps[0].data, map().cells);
}

TEST_F(BagSinkTest, CarriesWhatTheRunWasMadeOf) {
  write(config());
  McapReader reader(folder() / "bag" / "a_scenario.mcap");
  while (reader.next()) {
  }
  std::vector<std::string> names;
  for (const auto& attachment : reader.attachments()) names.push_back(attachment.name);
  EXPECT_EQ(names, (std::vector<std::string>{"scenario.yaml", "map.yaml", "map.pgm"}));
  EXPECT_EQ(reader.metadata().at("run").at("seed"), "7");
  EXPECT_EQ(reader.metadata().at("run").at("time_0_ns"), "1000000000");
  EXPECT_EQ(reader.metadata().at("run").at("start"), "1 2 0.5");
  EXPECT_EQ(reader.metadata().at("labels").at("4"), "thing 4");
}

TEST_F(BagSinkTest, NamesTheTopicsOfSeveralLidars) {
  BagConfig two = config();
  two.lidars.push_back({"rear/1", "laser", Eigen::Isometry3d::Identity()});
  write(two);
  EXPECT_EQ(messages_of<ros::LaserScan>(folder(), "/lidar/scan").size(), 2U);
  EXPECT_EQ(messages_of<ros::LaserScan>(folder(), "/scan").size(), 0U);
  const auto frames = messages_of<ros::TFMessage>(folder(), "/tf_static");
  EXPECT_EQ(frames.at(0).transforms.at(2).child_frame_id, "rear/1_frame");
}

TEST_F(BagSinkTest, GivesTheSameBytesForTheSameRun) {
  write(config());
  const std::string first = read_file(folder() / "bag" / "a_scenario.mcap");
  write(config());
  EXPECT_EQ(read_file(folder() / "bag" / "a_scenario.mcap"), first);
}

TEST(BagSink, TellsCommandsAndJointsWhereTheyAreKnown) {
  const TemporaryFolder folder;
  BagConfig known = config();
  double angle = 0.0;
  known.drive = [&angle] { return DriveNow{0.3, 0.1, {{"left", angle += 0.5}}}; };
  BagSink sink(folder.path(), run_of({"mh_amcl", "amcl-2"}), map(), known);
  play(sink);
  const auto commands = messages_of<ros::TwistStamped>(folder.path(), "/cmd_vel");
  const auto joints = messages_of<ros::JointState>(folder.path(), "/joint_states");
  ASSERT_EQ(commands.size(), 11U);
  ASSERT_EQ(joints.size(), 11U);
  EXPECT_EQ(commands[4].twist.linear.x, 0.3);
  EXPECT_NEAR(joints[4].position[0], 2.5, 1e-12);
  EXPECT_NEAR(joints[4].velocity[0], 5.0, 1e-6);
}

}  // namespace
}  // namespace castaway::testbed
