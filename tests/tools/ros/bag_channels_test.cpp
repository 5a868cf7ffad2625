#include "tools/ros/bag_channels.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/ros/mcap/mcap_reader.hpp"

namespace castaway::testbed {
namespace {

/// Topics of a bag with a message on each of these channels, by channel.
std::map<std::uint16_t, std::string> topics_of(const OptionalTopics& wanted) {
  const TemporaryFolder folder;
  BagWriter bag(folder.path() / "bag", "a", McapCompression::kNone);
  const BagChannels channels = add_channels(wanted, bag);
  bag.publish(channels.map, {}, ros::String{"any message"});
  bag.finish();
  McapReader reader(folder.path() / "bag" / "a.mcap");
  while (reader.next()) {
  }
  std::map<std::uint16_t, std::string> topics;
  for (const auto& [id, channel] : reader.channels()) topics[id] = channel.topic;
  return topics;
}

TEST(BagChannels, AreAlwaysInTheSameOrder) {
  std::vector<std::string> names;
  for (const auto& [id, topic] : topics_of({{"mh_amcl"}, true, true})) names.push_back(topic);
  EXPECT_EQ(names, (std::vector<std::string>{
                       "/map", "/tf_static", "/tf", "/odom", "/ground_truth/odom",
                       "/ground_truth/scan_pose", "/people", "/events", "/cmd_vel", "/joint_states",
                       "/mh_amcl/amcl_pose", "/mh_amcl/hypotheses", "/mh_amcl/particlecloud"}));
}

TEST(BagChannels, LeaveOutWhatIsNotWanted) {
  EXPECT_EQ(topics_of({{}, false, true}).size(), 8U);
  EXPECT_EQ(topics_of({{"a"}, false, false}).size(), 10U);
}

TEST(BagChannels, TellLocalizersOfSimilarNamesApart) {
  const auto topics = topics_of({{"a-b", "a/b"}, false, false});
  EXPECT_EQ(topics.rbegin()->second, "/a_b_/hypotheses");
}

}  // namespace
}  // namespace castaway::testbed
