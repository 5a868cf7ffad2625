#include "tools/outputs/sinks/tables_hdf5_sink.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/h5dump.hpp"
#include "tests/tools/support/table_records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

std::filesystem::path written(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  TablesHdf5Sink sink(folder, {"mh_amcl"}, table_context());
  play_two_scans(sink);
  return folder / "tables.h5";
}

TEST(TablesHdf5Sink, AnotherReaderFindsEveryColumn) {
  if (!h5dump_works()) GTEST_SKIP() << "h5dump is not installed (hdf5-tools)";
  const TemporaryFolder folder;
  const auto file = written(folder.path());
  const auto shows = [&](const std::string& path, const std::string& text) {
    return contains(h5dump(file, "-d " + path), text);
  };
  EXPECT_TRUE(shows("/lidars/front/ranges", "(0,0): 1.5, 0.75, inf"));
  EXPECT_TRUE(shows("/lidars/front/ranges", "(1,0): 1.5, 0.75, inf"));
  EXPECT_TRUE(shows("/lidars/front/classes", "(1,0): 1, 5, 0"));
  EXPECT_TRUE(shows("/lidars/front/hits", "(1,0): 0, 2, -1"));
  EXPECT_TRUE(shows("/lidars/front/stamp_s", "(0): 1, 2"));
  EXPECT_TRUE(shows("/lidars/front/pose", "(1,0): 0.2, 0, 0"));
  EXPECT_TRUE(shows("/lidars/front/since_kidnap_s", "(0): nan, 0.5"));
  EXPECT_TRUE(shows("/lidars/front/occluded", "(0): 0.333333, 0.333333"));
  EXPECT_TRUE(shows("/lidars/front/ambiguity", "(0): 0.25, 0.25"));
  EXPECT_TRUE(shows("/lidars/front/lost", "(1,0): 0"));
  EXPECT_TRUE(shows("/odometry/pose", "(0,0): 0.5, 0, 0.25"));
  EXPECT_TRUE(shows("/people/velocity", "(1,0): 1, -0.5"));
  EXPECT_TRUE(shows("/events/to", "(0,0): 0.15, 4, 0"));
  EXPECT_TRUE(shows("/events/detail", "teleport"));
  EXPECT_TRUE(shows("/objects/name", "wall"));
  EXPECT_TRUE(shows("/classes", "person"));
  EXPECT_TRUE(shows("/localizers", "mh_amcl"));
  EXPECT_TRUE(contains(h5dump(file, "-a /lidars/front/angle_increment_rad"), "(0): 0.25"));
  EXPECT_TRUE(contains(h5dump(file, "-a /lidars/front/mount_yaw_rad"), "(0): 1.5"));
}

TEST(TablesHdf5Sink, OnSeveralFloorsTruePosesHaveHeightRollAndPitch) {
  if (!h5dump_works()) GTEST_SKIP() << "h5dump is not installed (hdf5-tools)";
  const TemporaryFolder folder;
  TablesHdf5Sink sink(folder.path(), {"mh_amcl"}, table_context());
  play_two_scans(sink, on_a_ramp());
  const auto file = folder.path() / "tables.h5";
  const std::string text = "3.5, 0.25, -0.125";
  EXPECT_TRUE(contains(h5dump(file, "-d /lidars/front/height_roll_pitch"), "(1,0): " + text));
  EXPECT_TRUE(contains(h5dump(file, "-d /odometry/true_height_roll_pitch"), "(0,0): " + text));
}

TEST(TablesHdf5Sink, TheSameRunGivesTheSameBytes) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_file(written(folder.path() / "a")), read_file(written(folder.path() / "b")));
}

}  // namespace
}  // namespace castaway::testbed
