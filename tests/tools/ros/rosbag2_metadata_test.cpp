#include "tools/ros/rosbag2_metadata.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

BagContents contents() {
  return {"a.mcap",
          1'000'000'000,
          2'500'000'000,
          12,
          {{"/map", "nav_msgs/msg/OccupancyGrid", Durability::kTransientLocal, 1},
           {"/scan", "sensor_msgs/msg/LaserScan", Durability::kVolatile, 11}}};
}

TEST(Rosbag2Metadata, IsYamlOfVersionFive) {
  YamlDocument document = YamlDocument::parse(rosbag2_metadata(contents()), "metadata.yaml");
  YamlReader bag = document.root().child("rosbag2_bagfile_information");
  EXPECT_EQ(bag.require<int>("version"), 5);
  EXPECT_EQ(bag.require<std::string>("storage_identifier"), "mcap");
  EXPECT_EQ(bag.child("starting_time").require<std::uint64_t>("nanoseconds_since_epoch"),
            1'000'000'000U);
  EXPECT_EQ(bag.child("duration").require<std::uint64_t>("nanoseconds"), 2'500'000'000U);
  EXPECT_EQ(bag.require<int>("message_count"), 12);
  auto topics = bag.list("topics_with_message_count");
  ASSERT_EQ(topics.size(), 2U);
  EXPECT_EQ(topics[1].require<int>("message_count"), 11);
  YamlReader scan = topics[1].child("topic_metadata");
  EXPECT_EQ(scan.require<std::string>("name"), "/scan");
  EXPECT_EQ(scan.require<std::string>("type"), "sensor_msgs/msg/LaserScan");
  EXPECT_EQ(scan.require<std::string>("serialization_format"), "cdr");
  EXPECT_EQ(bag.require<std::vector<std::string>>("relative_file_paths"),
            std::vector<std::string>{"a.mcap"});
  EXPECT_EQ(bag.list("files")[0].require<std::string>("path"), "a.mcap");
  EXPECT_EQ(bag.require<std::string>("compression_mode"), "");
}

TEST(Rosbag2Metadata, TellsQosInNumbers) {
  YamlDocument document = YamlDocument::parse(rosbag2_metadata(contents()), "metadata.yaml");
  auto topics =
      document.root().child("rosbag2_bagfile_information").list("topics_with_message_count");
  const auto durability = [&](std::size_t topic) {
    const auto text =
        topics[topic].child("topic_metadata").require<std::string>("offered_qos_profiles");
    YamlDocument qos = YamlDocument::parse("profiles:\n" + text, "qos");
    return qos.root().list("profiles")[0].require<int>("durability");
  };
  EXPECT_EQ(durability(0), 1);  // transient local
  EXPECT_EQ(durability(1), 2);  // volatile
}

TEST(Rosbag2Metadata, OfAnEmptyBagIsYamlToo) {
  YamlDocument document = YamlDocument::parse(rosbag2_metadata({"a.mcap", 0, 0, 0, {}}), "m");
  YamlReader bag = document.root().child("rosbag2_bagfile_information");
  EXPECT_TRUE(bag.list("topics_with_message_count").empty());
}

}  // namespace
}  // namespace castaway::testbed
