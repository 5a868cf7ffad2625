#include "tools/build/bag/bag_reading.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/ros_bag.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/outputs/sinks/bag_sink.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

std::int64_t ns(double t) { return static_cast<std::int64_t>(t * 1e9 + 0.5); }

BagRecording read_files(const std::vector<std::filesystem::path>& files) {
  const BagInventory bag = take_inventory(files.front().string(), files);
  return read_bag(bag, choose_topics(bag, {}));
}

/// Reads a bag with these messages.
BagRecording recording_of(const std::function<void(ForeignBag&)>& fill) {
  const TemporaryFolder folder;
  ForeignBag bag(folder.path() / "a.mcap");
  fill(bag);
  bag.finish();
  return read_files({folder.path() / "a.mcap"});
}

const ScanFrame& scan_in(const BagRecording& recording, std::size_t index) {
  return std::get<ScanFrame>(recording.frames.at(index).data);
}

const OdometryFrame& odometry_in(const BagRecording& recording, std::size_t index) {
  return std::get<OdometryFrame>(recording.frames.at(index).data);
}

TEST(BagReading, PlaysARobotsOwnRecording) {
  const BagRecording recording = recording_of([](ForeignBag& bag) {
    bag.add("/tf_static", ns(100.0), ros_edge(100.0, "base_link", "laser", 0.25));
    bag.add("/odom", ns(100.01), ros_odometry_at(100.0, 1.0));
    bag.add("/scan", ns(100.2), ros_scan_at(100.1, "laser"));
  });
  EXPECT_TRUE(recording.warnings.empty());
  ASSERT_EQ(recording.frames.size(), 2U);
  EXPECT_EQ(odometry_in(recording, 0).odometry.stamp, Stamp(0));  // The first stamp is time 0.
  EXPECT_EQ(odometry_in(recording, 0).odometry.T_odom_base.x, 1.0);
  EXPECT_EQ(recording.frames[0].stamp, milliseconds(10));
  const ScanFrame& scan = scan_in(recording, 1);
  EXPECT_EQ(scan.scan.stamp, milliseconds(100));
  EXPECT_EQ(recording.frames[1].stamp, milliseconds(200));
  EXPECT_EQ(scan.scan.ranges, (std::vector<float>{1.0F, 2.0F, 3.0F}));
  EXPECT_EQ(scan.scan.T_base_laser.translation().x(), 0.25);
  EXPECT_FALSE(scan.true_pose);
}

TEST(BagReading, MountsScansByATreeThatComesLater) {
  const BagRecording recording = recording_of([](ForeignBag& bag) {
    bag.add("/scan", ns(1.0), ros_scan_at(1.0, "laser"));
    bag.add("/odom", ns(1.1), ros_odometry_at(1.1, 1.0));
    bag.add("/tf_static", ns(1.2), ros_edge(1.2, "base_link", "laser", 0.25));
  });
  EXPECT_EQ(scan_in(recording, 0).scan.T_base_laser.translation().x(), 0.25);
}

TEST(BagReading, WarnsOfALidarWhosePlaceNobodyTells) {
  const BagRecording recording = recording_of([](ForeignBag& bag) {
    bag.add("/odom", ns(1.0), ros_odometry_at(1.0, 1.0));
    for (const double t : {1.0, 1.1}) bag.add("/scan", ns(t), ros_scan_at(t, "laser"));
  });
  ASSERT_EQ(recording.warnings.size(), 1U);
  EXPECT_TRUE(contains(recording.warnings[0], "no transform from 'base_link' to 'laser'"));
}

TEST(BagReading, TakesOdometryFromTheTree) {
  const BagRecording recording = recording_of([](ForeignBag& bag) {
    bag.add("/tf", ns(1.0), ros_edge(1.0, "odom", "base_footprint", 1.0));
    bag.add("/tf", ns(1.0), ros_edge(1.0, "map", "odom", 9.0));
    bag.add("/tf", ns(1.5), ros_edge(1.5, "odom", "base_footprint", 2.0));
    bag.add("/scan", ns(1.6), ros_scan_at(1.6, "base_footprint"));
  });
  ASSERT_EQ(recording.frames.size(), 3U);
  EXPECT_EQ(odometry_in(recording, 1).odometry.T_odom_base.x, 2.0);
  EXPECT_EQ(odometry_in(recording, 1).odometry.stamp, milliseconds(500));
  EXPECT_TRUE(recording.warnings.empty());
}

TEST(BagReading, KeepsTheOrderOfTheFileAtOneTime) {
  const BagRecording recording = recording_of([](ForeignBag& bag) {
    for (const double t : {1.0, 1.1}) {
      bag.add("/tf", ns(t), ros_edge(t, "odom", "base_footprint", t));
      bag.add("/scan", ns(t), ros_scan_at(t, "base_footprint"));
    }
  });
  ASSERT_EQ(recording.frames.size(), 4U);
  EXPECT_EQ(odometry_in(recording, 0).odometry.T_odom_base.x, 1.0);
  EXPECT_EQ(scan_in(recording, 1).scan.stamp, Stamp(0));
  EXPECT_EQ(odometry_in(recording, 2).odometry.T_odom_base.x, 1.1);
  EXPECT_EQ(scan_in(recording, 3).scan.stamp, milliseconds(100));
}

TEST(BagReading, NamesEdgesThatCouldBeOdometry) {
  const std::string error = error_of([] {
    recording_of([](ForeignBag& bag) {
      bag.add("/tf", ns(1.0), ros_edge(1.0, "a/odom", "a/base", 0.0));
      bag.add("/tf", ns(1.0), ros_edge(1.0, "b/odom", "b/base", 0.0));
      bag.add("/scan", ns(1.0), ros_scan_at(1.0, "a/base"));
    });
  });
  EXPECT_TRUE(
      contains(error, "2 edges that could be odometry (a/odom -> a/base, b/odom -> b/base)"));
}

TEST(BagReading, BringsTwoClocksTogether) {
  const BagRecording recording = recording_of([](ForeignBag& bag) {
    bag.add("/odom", ns(5000.25), ros_odometry_at(1.0, 1.0));
    bag.add("/scan", ns(5000.4), ros_scan_at(1.1, "base_link"));
  });
  EXPECT_EQ(recording.frames[0].stamp, Stamp(0));
  EXPECT_EQ(recording.frames[1].stamp, milliseconds(150));
  EXPECT_EQ(scan_in(recording, 1).scan.stamp, milliseconds(100));
}

TEST(BagReading, InterpolatesTheTruthButNotOverAJump) {
  const BagRecording recording = recording_of([](ForeignBag& bag) {
    bag.add("/odom", ns(1.0), ros_odometry_at(1.0, 1.0));
    for (const auto& [t, x] : {std::pair{1.0, 0.0}, {1.2, 0.1}, {1.4, 5.0}}) {
      ros::Odometry truth = ros_odometry_at(t, x);
      truth.header.frame_id = "map";
      bag.add("/ground_truth/odom", ns(t), truth);
    }
    for (const double t : {1.1, 1.3, 1.4}) bag.add("/scan", ns(t), ros_scan_at(t, "base_link"));
  });
  EXPECT_NEAR(scan_in(recording, 1).true_pose->T_map_base.x, 0.05, 1e-12);
  EXPECT_FALSE(scan_in(recording, 2).true_pose);
  EXPECT_EQ(scan_in(recording, 3).true_pose->T_map_base.x, 5.0);
  EXPECT_EQ(odometry_in(recording, 0).true_pose->T_map_base.x, 0.0);
}

TEST(BagReading, ReadsAMapOfTheBag) {
  const RosMap map{"m", 2, 2, 0.05, -1.0, 0.0, 0.0, {0, 100, -1, 0}};
  const BagRecording recording = recording_of([&](ForeignBag& bag) {
    bag.add("/map", ns(1.0), to_ros_grid(map));
    bag.add("/odom", ns(1.0), ros_odometry_at(1.0, 1.0));
    bag.add("/scan", ns(1.0), ros_scan_at(1.0, "base_link"));
  });
  ASSERT_TRUE(recording.map);
  EXPECT_EQ(recording.map->cells, map.cells);
  EXPECT_EQ(recording.map->resolution, 0.05);
}

TEST(BagReading, NamesTheTopicOfABrokenMessage) {
  const std::string error = error_of([] {
    recording_of([](ForeignBag& bag) {
      bag.add("/odom", ns(1.0), ros_odometry_at(1.0, std::numeric_limits<double>::quiet_NaN()));
      bag.add("/scan", ns(1.0), ros_scan_at(1.0, "base_link"));
    });
  });
  EXPECT_TRUE(contains(error, "a.mcap: topic /odom at 1000000000 ns: a pose holds no numbers"));
}

TEST(BagReading, PutsTheFilesOfABagTogether) {
  const TemporaryFolder folder;
  ForeignBag first(folder.path() / "a_0.mcap");
  first.add("/odom", ns(1.0), ros_odometry_at(1.0, 1.0));
  first.finish();
  ForeignBag second(folder.path() / "a_1.mcap");
  second.add("/scan", ns(1.5), ros_scan_at(1.5, "base_link"));
  second.finish();
  const BagRecording recording =
      read_files({folder.path() / "a_0.mcap", folder.path() / "a_1.mcap"});
  ASSERT_EQ(recording.frames.size(), 2U);
  EXPECT_EQ(scan_in(recording, 1).scan.stamp, milliseconds(500));
}

/// Writes a run to castaway's own bag and reads it back.
class OwnBag : public testing::Test {
 protected:
  OwnBag() {
    BagConfig config;
    config.lidars = {{"front", "laser", mount()}};
    config.start = SE2{1.0 / 3.0, -2.0, 0.5};
    BagSink sink(folder_.path(), run_of({}), {"m", 1, 1, 0.05, 0.0, 0.0, 0.0, {0}}, config);
    sink.on_odometry(odometry_);
    sink.on_event(kidnap_to(0.125));
    sink.on_scan(scan());
    sink.finish({}, {});
    recording_ = read_files({folder_.path() / "bag" / "a_scenario.mcap"});
  }

  static Eigen::Isometry3d mount() {
    return Eigen::Translation3d(0.1, 0.2, 0.3) *
           Eigen::AngleAxisd(3.0, Eigen::Vector3d(1.0, 0.1, 0.2).normalized());
  }
  static ScanRecord scan() {
    ScanRecord record = record_at(0.1, {});
    record.scan.stamp = record.stamp;
    record.scan.lidar = "front";
    record.scan.angle_min = -1.0 / 3.0;
    record.scan.angle_increment = 0.1;
    record.scan.time_increment = Stamp(277'777);
    record.scan.range_max = 3.5;
    record.scan.ranges = {1.0F, std::numeric_limits<float>::infinity()};
    record.scan.T_base_laser = mount();
    return record;
  }

  TemporaryFolder folder_;
  OdometryFrame odometry_{{milliseconds(50), {0.1, 0.2, 3.1}}, SE2{0.3, 0.4, -3.1}};
  BagRecording recording_;
};

TEST_F(OwnBag, BringsFramesBackInTheirOrderAndTimes) {
  ASSERT_EQ(recording_.frames.size(), 3U);
  EXPECT_EQ(recording_.frames[0].stamp, milliseconds(50));
  EXPECT_EQ(recording_.frames[1].stamp, milliseconds(125));
  EXPECT_EQ(recording_.frames[2].stamp, milliseconds(200));
  EXPECT_TRUE(recording_.warnings.empty());
  EXPECT_EQ(recording_.start, (SE2{1.0 / 3.0, -2.0, 0.5}));
}

TEST_F(OwnBag, BringsOdometryAndEventsBack) {
  const OdometryFrame& odometry = odometry_in(recording_, 0);
  EXPECT_EQ(odometry.odometry.stamp, milliseconds(50));
  EXPECT_EQ(odometry.odometry.T_odom_base.x, 0.1);
  EXPECT_EQ(odometry.odometry.T_odom_base.yaw, 3.1);
  EXPECT_EQ(odometry.true_pose->T_map_base.yaw, -3.1);
  EXPECT_TRUE(std::get<RunEvent>(recording_.frames[1].data).is<KidnapEvent>());
}

TEST_F(OwnBag, BringsScansBackToTheBit) {
  const ScanFrame& back = scan_in(recording_, 2);
  EXPECT_EQ(back.scan.stamp, milliseconds(100));
  EXPECT_EQ(back.scan.angle_min, -1.0 / 3.0);
  EXPECT_EQ(back.scan.angle_increment, 0.1);
  EXPECT_EQ(back.scan.time_increment, Stamp(277'777));
  EXPECT_EQ(back.scan.ranges, scan().scan.ranges);
  EXPECT_EQ(back.scan.lidar, "front");
  EXPECT_EQ(back.truth.frame, "laser");
  EXPECT_EQ(back.scan.T_base_laser.matrix(), mount().matrix());
  EXPECT_NEAR(back.true_pose->T_map_base.x, 0.01, 1e-15);
}

}  // namespace
}  // namespace castaway::testbed
