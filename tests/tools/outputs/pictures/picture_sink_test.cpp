#include "tools/outputs/pictures/picture_sink.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/scene/primitives.hpp"
#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

const PictureConfig kSmall{.width = 64, .height = 48};

PictureWorld map_only() {
  RosMap map;
  map.width = 4;
  map.height = 4;
  map.resolution = 1.0;
  map.cells.assign(16, 0);
  PictureWorld world;
  world.map = map;
  return world;
}

/// Names of the pictures of a run of 8 s with a kidnap at 2.5 s; the output is right again from 4 s
/// on.
std::vector<std::string> pictures_of(PictureWorld world, const PictureConfig& config,
                                     bool known_start = true) {
  const TemporaryFolder folder;
  RunInfo info = run_of({"a"});
  info.known_start = known_start;
  PictureSink sink(folder.path(), info, std::move(world), config);
  for (int i = 0; i < 16; ++i) {
    if (i == 6) sink.on_event(kidnap_to(2.5));
    ScanRecord record = record_at(0.5 * i, {"a"});
    if (i >= 5) record.true_pose->T_map_base.y = 4.0;
    if (i >= 8) record.localizers[0].estimate->T_map_base.y = 4.0;
    sink.on_scan(record);
  }
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "snapshots")) {
    names.push_back(entry.path().filename().string());
    EXPECT_TRUE(read_file(entry.path()).starts_with("\x89PNG")) << names.back();
  }
  std::sort(names.begin(), names.end());
  return names;
}

class PictureSinkTest : public testing::Test {
 protected:
  void SetUp() override {
    const TemporaryFolder folder;
    const PictureSink sink(folder.path(), run_of({"a"}), {}, kSmall);
    if (sink.missing()) GTEST_SKIP() << *sink.missing();
  }
};

TEST_F(PictureSinkTest, ShowsKidnapsAndRecoveries) {
  EXPECT_EQ(pictures_of(map_only(), kSmall),
            (std::vector<std::string>{"t0003.000-kidnap-1-map.png",
                                      "t0005.000-recovery-1-map.png"}));  // right for one second
}

TEST_F(PictureSinkTest, ShowsTheRecoveryFromAnUnknownStart) {
  EXPECT_EQ(pictures_of(map_only(), kSmall, false).front(), "t0001.000-recovery-0-map.png");
}

TEST_F(PictureSinkTest, ShowsTheRoomWhereThereIsOne) {
  PictureWorld world = map_only();
  world.world.push_back({sim::arrow_mesh(1.0F, 1.0F)});
  const auto names = pictures_of(std::move(world), kSmall);
  ASSERT_EQ(names.size(), 6U);
  EXPECT_EQ(names[0], "t0003.000-kidnap-1-chase.png");
  EXPECT_EQ(names[2], "t0003.000-kidnap-1-overview.png");
}

TEST_F(PictureSinkTest, ShowsTheRunByTime) {
  PictureConfig config = kSmall;
  config.every_s = 3.0;
  config.on_events = false;
  EXPECT_EQ(pictures_of(map_only(), config),
            (std::vector<std::string>{"t0000.000-time-map.png", "t0003.000-time-map.png",
                                      "t0006.000-time-map.png"}));
}

/// Checks that a sink without EGL takes no picture and says why.
bool says_why_there_are_none() {
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
  const TemporaryFolder folder;
  PictureSink sink(folder.path(), run_of({"a"}), map_only(), kSmall);
  sink.on_event(kidnap_to(0.5));
  sink.on_scan(record_at(1.0, {"a"}));
  sink.finish(Stamp{}, {});
  const std::string why = read_file(folder.path() / "snapshots/none.txt");
  return sink.missing() && why == *sink.missing() + "\n" && why.find("EGL") != std::string::npos;
}

TEST(PictureSinkDeathTest, WithoutEglSaysWhy) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // a new process, which has not loaded EGL
                                                         // yet
  EXPECT_EXIT(std::exit(says_why_there_are_none() ? 0 : 1), testing::ExitedWithCode(0), "");
}

TEST(PictureConfig, RefusesWhatIsOutOfRange) {
  EXPECT_NO_THROW(validate(PictureConfig{}));
  EXPECT_THROW(validate(PictureConfig{.every_s = -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(PictureConfig{.width = 15}), std::invalid_argument);
  EXPECT_THROW(validate(PictureConfig{.height = 8193}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::testbed
