#include "tools/live/lines/bridge_link.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using testing::ElementsAre;

/// Notes what is written to it.
class Notes final : public TopicWriter {
 public:
  std::uint16_t add(const BagTopic& topic, const char*,
                    std::map<std::string, std::string>) override {
    const bool latched = topic.durability == Durability::kTransientLocal;
    lines.push_back("topic " + topic.name + " " + topic.type + (latched ? " latched" : ""));
    names_.push_back(topic.name);
    return static_cast<std::uint16_t>(names_.size() - 1);
  }
  void write(std::uint16_t topic, Stamp delivered, const std::string& message) override {
    lines.push_back(names_.at(topic) + " " + std::to_string(delivered.count()) + " " + message);
  }
  std::vector<std::string> lines;

 private:
  std::vector<std::string> names_;
};

class BridgeLinkTest : public testing::Test {
 protected:
  BridgeLinkTest() {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0);
    reader_ = std::thread([this] { publish_link(ends_[1], notes_); });
  }
  ~BridgeLinkTest() override {
    if (reader_.joinable()) (void)lines();
  }
  [[nodiscard]] int end() const { return ends_[0]; }
  /// What came, once the line is cut.
  const std::vector<std::string>& lines() {
    close(ends_[0]);
    reader_.join();
    close(ends_[1]);
    return notes_.lines;
  }

 private:
  std::array<int, 2> ends_{};
  Notes notes_;
  std::thread reader_;
};

TEST_F(BridgeLinkTest, HandsTopicsAndMessagesOn) {
  BridgeLink link(end());
  const auto map =
      link.add({"/map", "nav_msgs/msg/OccupancyGrid", Durability::kTransientLocal, 0}, "", {});
  const auto scan =
      link.add({"/scan", "sensor_msgs/msg/LaserScan", Durability::kVolatile, 0}, "", {});
  link.write(scan, Stamp(5), "beams");
  link.write(map, Stamp(-7), std::string(100'000, 'm'));
  EXPECT_THAT(lines(), ElementsAre("topic /map nav_msgs/msg/OccupancyGrid latched",
                                   "topic /scan sensor_msgs/msg/LaserScan", "/scan 5 beams",
                                   "/map -7 " + std::string(100'000, 'm')));
}

TEST_F(BridgeLinkTest, AnotherRunKeepsTheTopicsOfTheOneBefore) {
  BridgeLink link(end());
  link.add({"/people", "a/msg/B", Durability::kVolatile, 0}, "", {});
  link.add({"/scan", "a/msg/C", Durability::kVolatile, 0}, "", {});
  link.restart();
  const auto scan = link.add({"/scan", "a/msg/C", Durability::kVolatile, 0}, "", {});
  EXPECT_EQ(scan, 0);
  link.write(scan, Stamp(1), "x");
  EXPECT_THAT(lines(), ElementsAre("topic /people a/msg/B", "topic /scan a/msg/C", "/scan 1 x"));
}

TEST_F(BridgeLinkTest, IsSilentWhileMute) {
  BridgeLink link(end());
  const auto scan = link.add({"/scan", "a/msg/C", Durability::kVolatile, 0}, "", {});
  link.mute(true);
  link.write(scan, Stamp(1), "x");
  link.mute(false);
  link.write(scan, Stamp(2), "y");
  EXPECT_THAT(lines(), ElementsAre("topic /scan a/msg/C", "/scan 2 y"));
}

}  // namespace
}  // namespace castaway::testbed
