#include "tools/base/formats/tum.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::nanoseconds;

TEST(Tum, HasEightColumnsAndSingleSpaces) {
  EXPECT_EQ(tum_line({nanoseconds(1'500'000'001), {1.0, -2.5, std::numbers::pi / 2}}),
            "1.500000001 1.000000000 -2.500000000 0.000000000 0.000000000 0.000000000 0.707106781 "
            "0.707106781\n");
}

TEST(Tum, WritesNoNegativeZero) {
  EXPECT_EQ(tum_line({nanoseconds(0), {-1e-12, 0.0, -1e-12}}),
            "0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 "
            "1.000000000\n");
}

std::vector<StampedPose> read_tum_text(const std::string& text) {
  const TemporaryFolder folder;
  return read_tum(folder.put("poses.tum", text));
}

/// The error of a text as `poses.tum`, without the folder.
std::string tum_error(const std::string& text) {
  const std::string error = error_of([&] { (void)read_tum_text(text); });
  const std::size_t name = error.find("poses.tum");
  return name == std::string::npos ? error : error.substr(name);
}

TEST(ReadTum, ReadsWhatIsWritten) {
  const std::vector<StampedPose> written = {{nanoseconds(0), {0.0, 0.0, 0.0}},
                                            {nanoseconds(1), {1.25, -2.5, 0.7}},
                                            {nanoseconds(1'500'000'001), {-1e4, 3e5, -2.9}},
                                            {nanoseconds(1'700'000'000'123'456'789), {0, 1, 3.1}}};
  std::string text;
  for (const StampedPose& pose : written) text += tum_line(pose);
  const std::vector<StampedPose> read = read_tum_text(text);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    // A double holds the time since 1970 within half a microsecond.
    EXPECT_NEAR(static_cast<double>((read[i].stamp - written[i].stamp).count()), 0.0,
                i == 3 ? 250.0 : 0.0);
    EXPECT_NEAR(read[i].T_map_base.x, written[i].T_map_base.x, 1e-9);
    EXPECT_NEAR(read[i].T_map_base.y, written[i].T_map_base.y, 1e-9);
    EXPECT_NEAR(read[i].T_map_base.yaw, written[i].T_map_base.yaw, 1e-8);
  }
}

TEST(ReadTum, SkipsCommentsAndBlankLines) {
  const auto poses = read_tum_text(
      "# timestamp tx ty tz qx qy qz qw\n\n1 2 3 0 0 0 0 1\n  \t\r\n#2 x\n"
      "\t 2.5   -1e1\t4 0 0 0 1 0 \r\n3 0 0 0 0 0 0 1");
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_EQ(poses[0].stamp, std::chrono::seconds(1));
  EXPECT_EQ(poses[0].T_map_base, (localization::SE2{2.0, 3.0, 0.0}));
  EXPECT_EQ(poses[1].stamp, std::chrono::milliseconds(2500));
  EXPECT_EQ(poses[1].T_map_base.x, -10.0);
  EXPECT_NEAR(std::abs(poses[1].T_map_base.yaw), std::numbers::pi, 1e-12);
  EXPECT_EQ(poses[2].stamp, std::chrono::seconds(3));
}

TEST(ReadTum, DropsHeightRollAndPitch) {
  // Yaw 0.8, then roll 0.3 about the new x axis.
  const double c = std::cos(0.4) * std::cos(0.15);
  const double x = std::cos(0.4) * std::sin(0.15);
  const double y = std::sin(0.4) * std::sin(0.15);
  const double z = std::sin(0.4) * std::cos(0.15);
  const auto number = [](double value) { return std::to_string(value) + " "; };
  const auto poses =
      read_tum_text("0 1 2 9.5 " + number(x) + number(y) + number(z) + number(c) + "\n");
  EXPECT_NEAR(poses.at(0).T_map_base.yaw, 0.8, 1e-5);
  EXPECT_EQ(poses[0].T_map_base.x, 1.0);
  EXPECT_EQ(poses[0].T_map_base.y, 2.0);
}

TEST(ReadTum, NamesTheLineThatIsMalformed) {
  const std::string good = "# poses\n\n1 2 3 0 0 0 0 1\n";
  for (const char* line : {"2 2 3 0 0 0 0", "2 2 3 0 0 0 0 1 7", "2 2 three 0 0 0 0 1",
                           "2,2,3,0,0,0,0,1", "2 2 3 0 0 0 0 1x", "2 nan 3 0 0 0 0 1",
                           "2 2 inf 0 0 0 0 1", "1e300 2 3 0 0 0 0 1", "pose"}) {
    EXPECT_TRUE(contains(tum_error(good + line + "\n3 0 0 0 0 0 0 1\n"), "poses.tum:4: no pose"))
        << line;
  }
  EXPECT_TRUE(contains(tum_error("x"), "poses.tum:1: no pose"));
}

TEST(ReadTum, NamesTheLineWhoseTimeDoesNotIncrease) {
  const std::string first = "1.5 2 3 0 0 0 0 1\n# again\n";
  EXPECT_TRUE(contains(tum_error(first + "1.5 2 3 0 0 0 0 1\n"), "poses.tum:3: its time"));
  EXPECT_TRUE(contains(tum_error(first + "1.4 2 3 0 0 0 0 1\n"), "poses.tum:3: its time"));
  EXPECT_EQ(read_tum_text("-2 0 0 0 0 0 0 1\n-1 0 0 0 0 0 0 1\n").size(), 2U);
}

TEST(ReadTum, NamesAFileWithoutPosesOrThatIsMissing) {
  EXPECT_TRUE(contains(tum_error(""), "poses.tum: holds no poses"));
  EXPECT_TRUE(contains(tum_error("# nothing\n\n"), "poses.tum: holds no poses"));
  EXPECT_TRUE(contains(error_of([] { (void)read_tum("/nowhere/missing.tum"); }), "missing.tum"));
}

TEST(ReadTum, OfADegenerateRotationIsUnturned) {
  EXPECT_EQ(read_tum_text("0 1 2 0 0 0 0 0\n").at(0).T_map_base.yaw, 0.0);
}

}  // namespace
}  // namespace castaway::testbed
