#include "tools/ros/bag_channels.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/ros/bag_writer.hpp"

namespace castaway::testbed {
namespace {

/// Topics of a bag, in the order of their channels.
std::vector<std::string> topics_of(const OptionalTopics& wanted) {
  const TemporaryFolder folder;
  BagWriter bag(folder.path() / "bag", "a", Compression::kNone);
  add_channels(wanted, bag);
  bag.finish();
  std::istringstream metadata(read_file(folder.path() / "bag" / "metadata.yaml"));
  std::vector<std::string> topics;
  for (std::string line; std::getline(metadata, line);) {
    const std::size_t name = line.find("name: /");
    if (name != std::string::npos) topics.push_back(line.substr(name + 6));
  }
  return topics;
}

TEST(BagChannels, AreAlwaysInTheSameOrder) {
  EXPECT_EQ(topics_of({{"mh_amcl"}, true, true}),
            (std::vector<std::string>{"/map", "/tf_static", "/tf", "/odom", "/ground_truth/odom",
                                      "/ground_truth/scan_pose", "/people", "/events", "/cmd_vel",
                                      "/joint_states", "/mh_amcl/amcl_pose", "/mh_amcl/hypotheses",
                                      "/mh_amcl/particlecloud"}));
}

TEST(BagChannels, LeaveOutWhatIsNotWanted) {
  EXPECT_EQ(topics_of({{}, false, true}).size(), 8U);
  EXPECT_EQ(topics_of({{"a"}, false, false}).size(), 10U);
}

TEST(BagChannels, TellLocalizersOfSimilarNamesApart) {
  const auto topics = topics_of({{"a-b", "a/b"}, false, false});
  EXPECT_EQ(topics.back(), "/a_b_/hypotheses");
}

}  // namespace
}  // namespace castaway::testbed
