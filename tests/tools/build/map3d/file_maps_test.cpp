// 3-D maps of files, as replays use them.
#include <gtest/gtest.h>

#include "localization/space/map3d/voxel_builder.hpp"
#include "tests/tools/support/map_value.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/build/map3d/file_volume.hpp"
#include "tools/build/map3d/ground_plan.hpp"
#include "tools/build/map3d/map3d_files.hpp"
#include "tools/build/map3d/map_slice.hpp"

namespace castaway::testbed {
namespace {

/// A floor of 8 m x 4 m, with a wall of 2 m along its side at the smallest x.
std::vector<Eigen::Vector3d> walled_floor() {
  std::vector<Eigen::Vector3d> points;
  for (double x = 0.025; x < 8.0; x += 0.05) {
    for (double y = 0.025; y < 4.0; y += 0.05) points.emplace_back(x, y, 0.01);
  }
  for (double y = 0.025; y < 4.0; y += 0.05) {
    for (double z = 0.025; z < 2.0; z += 0.05) points.emplace_back(-0.05, y, z);
  }
  return points;
}

TEST(GroundPlan, ShowsDrivableGroundAndWalls) {
  const RosMap plan = ground_plan(survey_map3d(walled_floor(), {}), "hall");
  EXPECT_EQ(plan.name, "hall");
  EXPECT_EQ(value_at(plan, 4.0, 2.0), 0);
  EXPECT_EQ(value_at(plan, -0.05, 2.0), 100);
  EXPECT_EQ(plan.width * plan.height, static_cast<int>(plan.cells.size()));
}

TEST(MapSlice, ShowsWhatIsAtItsHeight) {
  auto points = walled_floor();
  for (double y = 1.025; y < 3.0; y += 0.05) points.emplace_back(6.05, y, 1.25);  // A bar.
  points.emplace_back(10.05, 2.0, 1.25);  // No ground is before it.
  const Map3d map = survey_map3d(points, {});
  const RosMap low = map_slice(map, 0.52, "hall");
  EXPECT_EQ(low.name, "hall");
  EXPECT_EQ(value_at(low, 4.0, 2.0), 0);
  EXPECT_EQ(value_at(low, 6.05, 2.0), 0);
  EXPECT_EQ(value_at(low, -0.05, 2.0), 100);
  EXPECT_EQ(value_at(low, 9.0, 2.0), -1);
  const RosMap high = map_slice(map, 1.22, "hall");
  EXPECT_EQ(value_at(high, 6.05, 2.0), 100);
  EXPECT_EQ(value_at(high, 4.0, 2.0), 0);
}

TEST(MapSlice, SaysWhichHeightsThereAre) {
  try {
    static_cast<void>(map_slice(survey_map3d(walled_floor(), {}), 2.5, "hall"));
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "no surface is at the height 2.5 m: those of the map are from 0.00 to 2.00 m");
  }
}

TEST(FileVolume, IsSharedByEqualVoxels) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "hall.map3d";
  write_file(file, encode_map3d(survey_map3d(walled_floor(), {})));
  const auto volume = volume_of(file, std::make_shared<const Map3d>(read_map3d_file(file, {})));
  const auto first = volume(0.1);
  EXPECT_EQ(volume(0.2), first);  // A map keeps its voxels.
  EXPECT_EQ(first->voxels().resolution, 0.1);
}

TEST(FileVolume, OfACloudHasTheVoxelsOfItsLocalizer) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "hall.ply";
  std::string text;
  const auto points = walled_floor();
  for (const auto& p : points) {
    text +=
        std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
  }
  write_file(file, "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" +
                       text);
  const auto volume = volume_of(file, std::make_shared<const Map3d>(read_map3d_file(file, {})));
  EXPECT_EQ(volume(0.1)->voxels().resolution, 0.1);
  EXPECT_EQ(volume(0.2)->voxels().resolution, 0.2);
}

}  // namespace
}  // namespace castaway::testbed
