#include "tools/base/formats/carmen_log.hpp"

#include <numbers>

#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

const std::string kLog =
    "# a log\n"
    "PARAM robot_front_laser_max 80 nohost 0\n"
    "\n"
    "SONAR 3 1 2 3 what ever\n"
    "ODOM 1.0 2.0 7.0 0.1 0.2 0 100.5 host 0.5\n"
    "FLASER 3 1.5 80.0 2.5 1.1 2.1 0.1 1.0 2.0 0.2 100.75 host 0.75\r\n"
    "TRUEPOS 5 6 0.3 1.0 2.0 0.2 100.75 host 0.75\n";

std::string gzipped(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "x.gz").string();
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void expect_messages(const std::filesystem::path& path) {
  CarmenLogReader reader(path);
  const auto param = std::get<CarmenParam>(reader.next().value());
  EXPECT_EQ(param.name, "robot_front_laser_max");
  EXPECT_EQ(param.value, "80");
  const auto odometry = std::get<CarmenOdometry>(reader.next().value());
  EXPECT_EQ(odometry.time_s, 0.5);
  EXPECT_EQ(odometry.T_odom_base.x, 1.0);
  EXPECT_NEAR(odometry.T_odom_base.yaw, 7.0 - 2.0 * std::numbers::pi, 1e-12);
  const auto laser = std::get<CarmenLaser>(reader.next().value());
  EXPECT_EQ(laser.ranges, (std::vector<float>{1.5F, 80.0F, 2.5F}));
  EXPECT_EQ(laser.T_odom_laser, (localization::SE2{1.1, 2.1, 0.1}));
  EXPECT_EQ(laser.T_odom_base, (localization::SE2{1.0, 2.0, 0.2}));
  EXPECT_EQ(laser.time_s, 0.75);
  EXPECT_FALSE(laser.device);
  const auto truth = std::get<CarmenTruth>(reader.next().value());
  EXPECT_EQ(truth.T_map_base, (localization::SE2{5.0, 6.0, 0.3}));
  EXPECT_TRUE(contains(reader.place(), "log:7"));
  EXPECT_FALSE(reader.next());
}

TEST(CarmenLogReader, RefusesADevice) {
  EXPECT_THROW(CarmenLogReader("/dev/zero"), std::runtime_error);
}

TEST(CarmenLog, ReadsPlainText) {
  const TemporaryFolder folder;
  expect_messages(folder.put("log", kLog));
}

TEST(CarmenLog, ReadsGzip) {
  const std::string bytes = gzipped(kLog);
  const TemporaryFolder folder;
  expect_messages(folder.put("log", bytes));
}

TEST(CarmenLog, ReadsAnyFieldOfView) {
  const auto message = parse_carmen_line(
      "ROBOTLASER1 0 -2.0 4.0 0.5 30.0 0.01 0 2 1.0 2.0 1 77 1 2 0.1 0.5 2 0.1 0 0 0 0 0 9.5 host "
      "1.5");
  const auto laser = std::get<CarmenLaser>(message.value());
  EXPECT_EQ(laser.device->angle_min, -2.0);
  EXPECT_EQ(laser.device->field_of_view, 4.0);
  EXPECT_EQ(laser.device->angle_increment, 0.5);
  EXPECT_EQ(laser.device->range_max, 30.0);
  EXPECT_EQ(laser.ranges, (std::vector<float>{1.0F, 2.0F}));
  EXPECT_EQ(laser.T_odom_laser, (localization::SE2{1.0, 2.0, 0.1}));
  EXPECT_EQ(laser.T_odom_base, (localization::SE2{0.5, 2.0, 0.1}));
  EXPECT_EQ(laser.time_s, 1.5);
}

TEST(CarmenLog, NamesFileAndLineOfABrokenLine) {
  const TemporaryFolder folder;
  const auto path =
      folder.put("broken.log", "# one\nODOM 1 2 3 0 0 0 1 h 1\nODOM 1 2 x 0 0 0 1 h 1\n");
  CarmenLogReader reader(path);
  EXPECT_TRUE(reader.next());
  EXPECT_TRUE(contains(error_of([&] { reader.next(); }), "broken.log:3: ODOM: its pose is 'x'"));
}

TEST(CarmenLog, DoesNotTrustACount) {
  for (const std::string line : {"FLASER 999999999999 1 2 3", "FLASER 4 1 2 3", "FLASER -1 1 2",
                                 "ROBOTLASER1 0 -2 4 0.5 30 0.01 0 2 1 2 99999999 1 2"}) {
    EXPECT_NE(error_of([&] { parse_carmen_line(line); }), "") << line;
  }
}

TEST(CarmenLog, TellsWhatIsWrong) {
  EXPECT_TRUE(contains(error_of([] { parse_carmen_line("FLASER 2 1.0 nan 0 0 0 0 0 0 1 h 1"); }),
                       "FLASER: its ranges is 'nan'"));
  EXPECT_TRUE(contains(error_of([] { parse_carmen_line("TRUEPOS 1 2 3 4 5"); }), "ends before"));
  EXPECT_TRUE(contains(error_of([] { parse_carmen_line("PARAM name"); }), "ends before its value"));
}

TEST(CarmenLog, NoticesAGzipThatIsCutShort) {
  std::string text;
  for (int i = 0; i < 5000; ++i)
    text += "ODOM " + std::to_string(i * 7919 % 1000) + " 2 3 0 0 0 1 h 1\n";
  const std::string bytes = gzipped(text);
  const TemporaryFolder folder;
  const auto path = folder.put("short.log.gz", bytes.substr(0, bytes.size() / 2));
  const std::string error = error_of([&] {
    CarmenLogReader reader(path);
    while (reader.next()) {
    }
  });
  EXPECT_TRUE(contains(error, "short.log.gz:"));
}

TEST(CarmenLog, SaysWhatARawlogAndAPointerAre) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& bytes) {
    write_file(folder.path() / "x.rawlog", bytes);
    try {
      (void)CarmenLogReader(folder.path() / "x.rawlog");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal("\x8D"
                    "CSensoryFrame\x02")
                .find("a rawlog of MRPT"),
            std::string::npos);
  EXPECT_NE(refusal("version https://git-lfs.github.com/spec/v1\noid sha256:a\nsize 9\n")
                .find("Git LFS pointer: git lfs pull"),
            std::string::npos);
}

TEST(CarmenLog, NamesAMissingFile) {
  EXPECT_TRUE(contains(error_of([] { CarmenLogReader("/no/such.log"); }), "/no/such.log: cannot"));
}

}  // namespace
}  // namespace castaway::testbed
