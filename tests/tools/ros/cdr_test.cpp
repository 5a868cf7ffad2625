#include "tools/ros/cdr.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/ros/ros_sensor.hpp"
#include "tools/ros/ros_visualization.hpp"

namespace castaway::testbed {
namespace {

using namespace std::string_literals;

/// A message with fields of all alignments.
struct Mixed {
  static constexpr const char* kType = "test/msg/Mixed";
  std::uint8_t byte = 0;
  double number = 0.0;
  std::string text;
  std::vector<float> floats;
  bool flag = false;
  std::array<std::int32_t, 2> pair{};

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("byte", self.byte);
    visitor("number", self.number);
    visitor("text", self.text);
    visitor("floats", self.floats);
    visitor("flag", self.flag);
    visitor("pair", self.pair);
  }
};

const std::string kLittle =
    "\x00\x01\x00\x00"                        // plain CDR, little-endian
    "\x07\0\0\0\0\0\0\0"                      // byte, 7 to align 8
    "\0\0\0\0\0\0\xF8\x3F"                    // 1.5
    "\x03\0\0\0ab\0\0"                        // "ab", 1 to align 4
    "\x02\0\0\0\0\0\x80\x3F\0\0\0\xC0"        // 1, -2
    "\x01\0\0\0\x05\0\0\0\xFF\xFF\xFF\xFF"s;  // true, 3 to align, 5, -1

const std::string kBig =
    "\x00\x00\x00\x00"
    "\x07\0\0\0\0\0\0\0"
    "\x3F\xF8\0\0\0\0\0\0"
    "\0\0\0\x03"
    "ab\0\0"
    "\0\0\0\x02\x3F\x80\0\0\xC0\0\0\0"
    "\x01\0\0\0\0\0\0\x05\xFF\xFF\xFF\xFF"s;

Mixed mixed() { return {7, 1.5, "ab", {1.0F, -2.0F}, true, {5, -1}}; }

void expect_mixed(const Mixed& message) {
  EXPECT_EQ(message.byte, 7);
  EXPECT_EQ(message.number, 1.5);
  EXPECT_EQ(message.text, "ab");
  EXPECT_EQ(message.floats, (std::vector<float>{1.0F, -2.0F}));
  EXPECT_TRUE(message.flag);
  EXPECT_EQ(message.pair, (std::array<std::int32_t, 2>{5, -1}));
}

TEST(Cdr, AlignsFromBehindItsHeader) { EXPECT_EQ(CdrWriter::encode(mixed()), kLittle); }

TEST(Cdr, IsReadInBothByteOrders) {
  expect_mixed(CdrReader::decode<Mixed>(kLittle));
  expect_mixed(CdrReader::decode<Mixed>(kBig));
}

TEST(Cdr, IsReadWithPaddingBehind) { expect_mixed(CdrReader::decode<Mixed>(kLittle + "\0\0"s)); }

TEST(Cdr, RefusesEveryCut) {
  for (std::size_t size = 0; size < kLittle.size(); ++size) {
    EXPECT_THROW(CdrReader::decode<Mixed>(kLittle.substr(0, size)), std::runtime_error) << size;
  }
}

TEST(Cdr, BelievesNoCount) {
  std::string bytes = kLittle;
  bytes.replace(28, 4, "\xFF\xFF\xFF\x7F");  // floats
  EXPECT_TRUE(contains(error_of([&] { CdrReader::decode<Mixed>(bytes); }),
                       "claims 2147483647 elements and has 20 bytes left"));
}

TEST(Cdr, NamesAnEncodingThatItDoesNotRead) {
  EXPECT_TRUE(contains(error_of([] { CdrReader::decode<Mixed>("\x00\x03\x00\x00"s); }),
                       "encoded as 00 03"));
}

TEST(Cdr, BringsScansAndMarkersBack) {
  ros::LaserScan scan;
  scan.header.stamp = {12, 345};
  scan.header.frame_id = "laser";
  scan.ranges = {1.0F, std::numeric_limits<float>::infinity(), -2.5F};
  const auto read = CdrReader::decode<ros::LaserScan>(CdrWriter::encode(scan));
  EXPECT_EQ(read.header.stamp.nanosec, 345U);
  EXPECT_EQ(read.header.frame_id, "laser");
  EXPECT_EQ(read.ranges, scan.ranges);
  EXPECT_TRUE(read.intensities.empty());

  ros::MarkerArray markers;
  markers.markers.resize(2);
  markers.markers[1].text = "second";
  markers.markers[1].points.resize(3);
  markers.markers[1].points[2].z = 4.0;
  const auto back = CdrReader::decode<ros::MarkerArray>(CdrWriter::encode(markers));
  ASSERT_EQ(back.markers.size(), 2U);
  EXPECT_EQ(back.markers[1].text, "second");
  ASSERT_EQ(back.markers[1].points.size(), 3U);
  EXPECT_EQ(back.markers[1].points[2].z, 4.0);
}

}  // namespace
}  // namespace castaway::testbed
