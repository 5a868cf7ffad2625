#include "tools/ros/bag_writer.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/ros/bag_channels.hpp"
#include "tools/ros/storage/mcap_reader.hpp"

namespace castaway::testbed {
namespace {

TEST(BagWriter, MakesTopicsOfAnyName) {
  EXPECT_EQ(topic_part("mh_amcl"), "mh_amcl");
  EXPECT_EQ(topic_part("amcl-recovery/2"), "amcl_recovery_2");
  EXPECT_EQ(topic_part("2d"), "_2d");
  EXPECT_EQ(topic_part(""), "_");
}

TEST(BagWriter, NeverLogsBackInTime) {
  const TemporaryFolder folder;
  BagWriter bag(folder.path() / "bag", "a run", Compression::kZstd);
  const auto topic = bag.add_topic<ros::String>("/a");
  bag.publish(topic, std::chrono::seconds(2), ros::String{"late"});
  bag.publish(topic, std::chrono::seconds(1), ros::String{"early"});
  bag.finish();
  McapReader reader(folder.path() / "bag" / "a_run.mcap");
  EXPECT_EQ(reader.next()->log_time_ns, 3'000'000'000);
  const auto second = reader.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->log_time_ns, 3'000'000'000);
  EXPECT_EQ(CdrReader::decode<ros::String>(second->data).data, "early");
  EXPECT_EQ(second->channel->metadata.count("offered_qos_profiles"), 1U);
}

TEST(BagWriter, HoldsOneSchemaForEachType) {
  const TemporaryFolder folder;
  BagWriter bag(folder.path() / "bag", "a", Compression::kNone);
  const auto a = bag.add_topic<ros::String>("/a");
  const auto b = bag.add_topic<ros::String>("/b");
  bag.publish(a, {}, ros::String{"1"});
  bag.publish(b, {}, ros::String{"2"});
  bag.finish();
  McapReader reader(folder.path() / "bag" / "a.mcap");
  while (reader.next()) {
  }
  EXPECT_EQ(reader.channels().at(a).schema, reader.channels().at(b).schema);
}

}  // namespace
}  // namespace castaway::testbed
