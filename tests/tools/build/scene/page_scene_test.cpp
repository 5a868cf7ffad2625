#include "tools/build/scene/page_scene.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/scene/primitives.hpp"

namespace castaway::testbed {
namespace {

using PageJson = nlohmann::json;

sim::SceneItem ball(int rings) {
  sim::SceneItem item;
  item.mesh = sim::sphere_mesh(1.0F, rings);
  return item;
}

PageScene scene_of(int rings) {
  PageScene scene;
  scene.world.items = {ball(rings)};
  scene.world.floor_color = {1.0F, 0.5F, 0.25F};
  scene.world.min_corner = {-1.0, -2.0};
  scene.world.max_corner = {3.0, 4.0};
  scene.world.top = 2.0;
  scene.robot = {ball(4)};
  return scene;
}

TEST(PageScene, TellsOfFloorMeshesAndPeople) {
  PageScene scene = scene_of(8);
  scene.people = {{.height = 1.6, .leg_radius = 0.06}};
  const PageJson json = PageJson::parse(page_scene_json(scene, kReportSceneBytes));
  EXPECT_EQ(json.at("extent"), PageJson({-1.0, -2.0, 3.0, 4.0}));
  EXPECT_EQ(json.at("floor"), PageJson({1.0, 0.5, 0.25}));
  EXPECT_EQ(json.at("top"), 2.0);
  EXPECT_TRUE(json.at("roof").is_null());
  EXPECT_EQ(json.at("thinned_m"), 0.0);
  EXPECT_EQ(json.at("person").at("bodies"), PageJson::parse("[[1.6, 0.06]]"));
  EXPECT_GT(json.at("world").at("positions").get<std::string>().size(),
            json.at("robot").at("positions").get<std::string>().size());
}

TEST(PageScene, ChangingObjectsHaveALookForEachChange) {
  PageScene scene = scene_of(8);
  EXPECT_FALSE(PageJson::parse(page_scene_json(scene, kReportSceneBytes)).contains("changing"));
  scene.changing["crate"] = {{}, {ball(4)}, {}};
  const PageJson looks =
      PageJson::parse(page_scene_json(scene, kReportSceneBytes)).at("changing").at("crate");
  ASSERT_EQ(looks.size(), 3U);
  EXPECT_TRUE(looks[0].is_null());
  EXPECT_FALSE(looks[1].at("indices").get<std::string>().empty());
  EXPECT_TRUE(looks[2].is_null());
}

TEST(PageScene, RoofsAreApart) {
  PageScene scene = scene_of(8);
  const PageJson open = PageJson::parse(page_scene_json(scene, kReportSceneBytes));
  scene.world.roofs = {ball(3)};
  const PageJson roofed = PageJson::parse(page_scene_json(scene, kReportSceneBytes));
  EXPECT_FALSE(roofed.at("roof").at("indices").get<std::string>().empty());
  EXPECT_EQ(roofed.at("world"), open.at("world"));
}

TEST(PageScene, IsThinnedUntilItIsSmallEnough) {
  const PageScene scene = scene_of(150);
  constexpr std::size_t kMost = 300'000;
  EXPECT_GT(page_scene_json(scene, kLiveSceneBytes).size(), 2 * kMost);
  const std::string text = page_scene_json(scene, kMost);
  EXPECT_LT(text.size(), kMost + 100'000);  // People are not counted.
  const PageJson json = PageJson::parse(text);
  EXPECT_GT(json.at("thinned_m"), 0.0);
  EXPECT_LT(json.at("thinned_m"), 0.3);
  EXPECT_GT(json.at("world").at("indices").get<std::string>().size(), 10'000U);
}

TEST(PageScene, IsTheSameEveryTime) {
  EXPECT_EQ(page_scene_json(scene_of(20), 50'000), page_scene_json(scene_of(20), 50'000));
}

}  // namespace
}  // namespace castaway::testbed
