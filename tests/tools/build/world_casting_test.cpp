/// Ray casts in all shipped worlds, meshes included, against an independent loop over all objects.
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/sim/support/world_oracle.hpp"
#include "tests/support/sanitized.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/world/world_file.hpp"

namespace castaway::testbed {
namespace {

// Per world; world_cast_check casts millions.
constexpr long kBeams = test::kSanitized ? 3500 : 35000;

TEST(WorldCasting, AgreesWithAPlainLoopInAllShippedWorlds) {
  int worlds = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_root() / "worlds")) {
    if (!entry.is_directory()) continue;
    const WorldFile world = load_world(entry.path());
    const sim::CastComparison result = sim::compare_casts(world.spec, kBeams, 7);
    EXPECT_EQ(result.wrong, 0) << world.spec.name << ", worst " << result.worst;
    EXPECT_GT(result.hits, kBeams / 8) << world.spec.name;  // Outdoors, most end in the sky.
    ++worlds;
  }
  EXPECT_GE(worlds, 6);
}

/// The oracle is sensitive: moving a body by a millimetre is an error on every beam that meets it.
TEST(WorldCasting, WouldSeeAMillimetre) {
  sim::WorldSpec world;
  world.max_corner = {4.0, 4.0};
  sim::WorldObject box;
  box.shape = sim::BoxShape{{1.0, 1.0, 1.0}};
  box.T_map_object = Eigen::Translation3d(2.0, 2.0, 0.5);
  world.objects = {box};
  const sim::WorldOracle oracle(world);
  const sim::Ray ray{{0.0, 2.0, 0.5}, Eigen::Vector3d::UnitX()};
  EXPECT_DOUBLE_EQ(oracle.cast(ray, 10.0), 1.5);
  world.objects[0].T_map_object.translation().x() += 0.001;
  EXPECT_NEAR(sim::WorldOracle(world).cast(ray, 10.0), 1.501, 1e-12);
  EXPECT_EQ(sim::WorldOracle(world).cast(ray, 1.0), sim::kNoHit);
}

}  // namespace
}  // namespace castaway::testbed
