#include "tools/ros/bag_topics.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/ros_bag.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Names = std::vector<std::string>;

constexpr const char* kScan = ros::LaserScan::kType;
constexpr const char* kOdometry = ros::Odometry::kType;
constexpr const char* kTf = ros::TFMessage::kType;

BagInventory bag_of(const std::vector<std::pair<std::string, std::string>>& topics) {
  BagInventory bag;
  bag.name = "a.mcap";
  for (const auto& [name, type] : topics) bag.topics.push_back({name, type, "cdr", {}, 1});
  return bag;
}

std::string refusal(const BagInventory& bag, const BagTopicOptions& options = {}) {
  return error_of([&] { choose_topics(bag, options); });
}

TEST(BagTopics, AreCounted) {
  const TemporaryFolder folder;
  ForeignBag bag(folder.path() / "a.mcap");
  for (const double t : {1.0, 2.0}) {
    bag.add("/scan", static_cast<std::int64_t>(t * 1e9), ros_scan_at(t, "laser"));
  }
  bag.add("/odom", 3'000'000'000, ros_odometry_at(3.0, 0.0));
  bag.finish();
  const BagInventory inventory = take_inventory("a", {folder.path() / "a.mcap"});
  ASSERT_EQ(inventory.topics.size(), 2U);
  EXPECT_EQ(inventory.topics[0].name, "/odom");
  EXPECT_EQ(inventory.topics[1].type, kScan);
  EXPECT_EQ(inventory.topics[1].messages, 2U);
  EXPECT_EQ(inventory.start_ns, 1'000'000'000);
  EXPECT_EQ(inventory.end_ns, 3'000'000'000);
  EXPECT_EQ(inventory.messages, 3U);
}

TEST(BagTopics, AreChosenByType) {
  const BagTopicChoice choice = choose_topics(bag_of({{"/base/laser", kScan},
                                                      {"/wheels", kOdometry},
                                                      {"/tf", kTf},
                                                      {"/map", ros::OccupancyGrid::kType}}),
                                              {});
  EXPECT_EQ(choice.scans, Names{"/base/laser"});
  EXPECT_EQ(choice.odometry, "/wheels");
  EXPECT_EQ(choice.map, "/map");
  EXPECT_EQ(choice.truth, "");
}

TEST(BagTopics, CloudsAreChosenOn3dMaps) {
  const char* const kCloud = ros::PointCloud2::kType;
  BagInventory bag = bag_of({{"/odom", kOdometry}, {"/velodyne_points", kCloud}});
  BagTopicOptions options;
  EXPECT_TRUE(contains(refusal(bag, options), "holds no sensor_msgs/msg/LaserScan"));
  options.in_space = true;
  EXPECT_EQ(choose_topics(bag, options).clouds, Names{"/velodyne_points"});
  EXPECT_TRUE(choose_topics(bag, options).scans.empty());
  bag.topics.push_back({"/scan", kScan, "cdr", {}, 1});
  EXPECT_TRUE(choose_topics(bag, options).clouds.empty());  // Perhaps made of the scans.
  EXPECT_EQ(choose_topics(bag, options).scans, Names{"/scan"});
  options.clouds = {"/velodyne_points"};
  EXPECT_TRUE(choose_topics(bag, options).scans.empty());
  options.scans = {"/scan"};
  EXPECT_EQ(choose_topics(bag, options).scans, Names{"/scan"});
  EXPECT_EQ(choose_topics(bag, options).clouds, Names{"/velodyne_points"});
  options.clouds = {"/odom"};
  EXPECT_TRUE(contains(refusal(bag, options), "--points-topic /odom: its type is"));
}

TEST(BagTopics, OwnCloudsCompleteOwnScans) {
  BagInventory bag = bag_of({{"/odom", kOdometry}});
  const std::map<std::string, std::string> own = {{"castaway.lidar", "top"}};
  bag.topics.push_back({"/points", ros::PointCloud2::kType, "cdr", own, 1});
  bag.topics.push_back({"/scan", kScan, "cdr", own, 1});
  BagTopicOptions options;
  EXPECT_TRUE(choose_topics(bag, options).clouds.empty());
  options.in_space = true;
  EXPECT_EQ(choose_topics(bag, options).clouds, Names{"/points"});
  EXPECT_EQ(choose_topics(bag, options).scans, Names{"/scan"});
}

TEST(BagTopics, AnImuIsChosenIfOneIsWanted) {
  const auto chosen = [](const Names& imus, const std::string& named, bool any) {
    std::vector<std::pair<std::string, std::string>> topics = {{"/scan", kScan}, {"/tf", kTf}};
    for (const std::string& imu : imus) topics.emplace_back(imu, ros::Imu::kType);
    BagTopicOptions options;
    options.imu = named;
    options.in_space = any;
    return choose_topics(bag_of(topics), options).imu;
  };
  EXPECT_EQ(chosen({"/camera/imu"}, "", true), "/camera/imu");
  EXPECT_EQ(chosen({"/imu"}, "", false), "");
  EXPECT_EQ(chosen({"/imu"}, "/imu", false), "/imu");
  EXPECT_EQ(chosen({"/imu"}, "none", true), "");
  EXPECT_EQ(chosen({"/imu/data", "/imu/data_raw"}, "", true), "/imu/data");
  EXPECT_EQ(chosen({"/camera/imu", "/imu"}, "", true), "/imu");
  EXPECT_EQ(chosen({}, "", true), "");
  EXPECT_TRUE(contains(error_of([&] { (void)chosen({"/a", "/b"}, "", true); }), "--imu-topic"));
  EXPECT_TRUE(contains(error_of([&] { (void)chosen({}, "/scan", true); }), "--imu-topic /scan"));
}

TEST(BagTopics, FallBackToTheTreeForOdometry) {
  EXPECT_EQ(choose_topics(bag_of({{"/scan", kScan}, {"/tf", kTf}}), {}).odometry, "");
  EXPECT_TRUE(contains(refusal(bag_of({{"/scan", kScan}})), "holds neither nav_msgs/msg/Odometry"));
}

TEST(BagTopics, PreferTheUsualNameOfSeveral) {
  const auto bag = bag_of({{"/front/scan", kScan},
                           {"/odom", kOdometry},
                           {"/odometry/filtered", kOdometry},
                           {"/scan", kScan}});
  EXPECT_EQ(choose_topics(bag, {}).scans, Names{"/scan"});
  EXPECT_EQ(choose_topics(bag, {}).odometry, "/odom");
}

TEST(BagTopics, AreListedWhereSeveralCouldBeMeant) {
  const auto bag = bag_of({{"/a/scan", kScan}, {"/b/scan", kScan}, {"/odom", kOdometry}});
  EXPECT_TRUE(contains(refusal(bag),
                       "2 topics are possible; choose one with --scan-topic: /a/scan, /b/scan"));
  BagTopicOptions options;
  options.scans = {"/b/scan"};
  EXPECT_EQ(choose_topics(bag, options).scans, Names{"/b/scan"});
}

TEST(BagTopics, TakeAllLidarsOfOurOwnBags) {
  auto bag = bag_of({{"/a/scan", kScan}, {"/b/scan", kScan}, {"/odom", kOdometry}});
  for (BagTopicInfo& topic : bag.topics) topic.metadata["castaway.lidar"] = topic.name;
  EXPECT_EQ(choose_topics(bag, {}).scans, (Names{"/a/scan", "/b/scan"}));
}

TEST(BagTopics, SayWhatIsWrongWithAnOption) {
  const auto bag = bag_of({{"/scan", kScan}, {"/odom", kOdometry}});
  BagTopicOptions options;
  options.scans = {"/odom"};
  EXPECT_TRUE(contains(refusal(bag, options), "--scan-topic /odom: its type is nav_msgs"));
  options = {};
  options.truth = "/gps";
  EXPECT_TRUE(contains(refusal(bag, options), "--truth-topic /gps: there is no such topic"));
  EXPECT_TRUE(contains(refusal(bag, options), "/odom (nav_msgs/msg/Odometry)"));
}

TEST(BagTopics, SayThatThereAreNoScans) {
  EXPECT_TRUE(contains(refusal(bag_of({{"/odom", kOdometry}})),
                       "a.mcap: holds no sensor_msgs/msg/LaserScan; its topics are: /odom"));
}

TEST(BagTopics, MustBeOfRos2) {
  auto bag = bag_of({{"/scan", kScan}, {"/odom", kOdometry}});
  bag.topics[0].encoding = "json";
  EXPECT_TRUE(contains(refusal(bag), "/scan is encoded as 'json'"));
  bag.topics[0] = {"/chatter", "std_msgs/String", "ros1", {}, 1};  // As `mcap convert` keeps them.
  EXPECT_TRUE(contains(refusal(bag), "its messages are those of ROS 1; convert"));
}

TEST(BagTopics, NeverTakeTheTruthForOdometry) {
  const auto bag =
      bag_of({{"/ground_truth/odom", kOdometry}, {"/odom", kOdometry}, {"/scan", kScan}});
  EXPECT_EQ(choose_topics(bag, {}).odometry, "/odom");
  EXPECT_EQ(choose_topics(bag, {}).truth, "/ground_truth/odom");
}

}  // namespace
}  // namespace castaway::testbed
