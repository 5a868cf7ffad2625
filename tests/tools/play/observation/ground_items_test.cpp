#include "tools/play/observation/ground_items.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "localization/space/map3d/voxel_builder.hpp"
#include "tools/build/map3d/survey_map3d.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

const localization::EndpointConfig kGroundModel{0.1, 0.05, 30.0};

/// A plane that rises by 20 % along x, 12 m x 8 m, with a pole of 2 m at (8, 4), which stands on a
/// floor at -1 m.
localization::Volume slope_with_pole() {
  localization::VoxelBuilder builder(0.1);
  for (double x = 0.025; x < 12.0; x += 0.05) {
    for (double y = 0.025; y < 8.0; y += 0.05) {
      if (std::hypot(x - 8.0, y - 4.0) > 0.2) builder.add({x, y, 0.2 * x}, true);
    }
  }
  for (double z = -1.0; z < 3.6; z += 0.05) {
    for (double angle = 0.0; angle < 6.28; angle += 0.1) {
      builder.add({8.0 + 0.2 * std::cos(angle), 4.0 + 0.2 * std::sin(angle), z});
    }
  }
  Map3d map = survey_map3d(builder.build(), {});
  return {map.voxels, std::move(map.ground), {}};
}

TEST(GroundItems, IsThePlaneThatRises) {
  const localization::Volume volume = slope_with_pole();
  const MapWindow window{{4.0, 4.0, 0.0}, 0.8, 2.0};
  const GroundItems ground = ground_items(volume, kGroundModel, window, 0.3);
  ASSERT_GT(ground.surface.mesh.vertices.size(), 4U * 1000U);
  for (const Vector3f& vertex : ground.surface.mesh.vertices) {
    EXPECT_NEAR(vertex.z(), 0.2F * vertex.x(), 0.01F);
    EXPECT_NEAR(vertex.x(), 4.0F, 2.1F);
  }
  for (const Vector3f& normal : ground.surface.mesh.normals) {
    EXPECT_NEAR(normal.x() / normal.z(), -0.2F, 0.02F);
  }
  ASSERT_GT(ground.contours.points.size(), 20U);
  for (const Vector3f& point : ground.contours.points) {
    EXPECT_NEAR(std::remainder(point.z(), 0.5F), 0.0F, 1e-4F);
  }
}

TEST(ObstaclesItem, ShowsWhatStandsOnTheGroundAndNothingBelowIt) {
  const localization::Volume volume = slope_with_pole();
  const MapWindow window{{6.0, 4.0, 0.0}, 1.2, 4.0};
  const sim::SceneItem item = obstacles_item(volume, window);
  Eigen::AlignedBox3f box;
  for (const Vector3f& vertex : item.mesh.vertices) box.extend(vertex);
  EXPECT_NEAR(box.max().z(), 3.6F, 0.11F);
  EXPECT_GT(box.min().z(), 1.3F);  // The ground there is at 1.6 m.
  EXPECT_NEAR(box.center().x(), 8.0F, 0.1F);
  EXPECT_NEAR(box.sizes().x(), 0.4F, 0.2F);
}

}  // namespace
}  // namespace castaway::testbed
