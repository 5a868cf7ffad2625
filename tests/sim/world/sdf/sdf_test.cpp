#include "sim/world/sdf/load_sdf.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/map/rasterise.hpp"
#include "sim/world/footprint.hpp"
#include "tests/sim/world/sdf/sdf_files.hpp"

namespace castaway::sim {
namespace {

TEST_F(SdfFiles, ChainsTheFramesOfModelLinkAndCollision) {
  const SdfWorld world = load(
      "<model name='m'><static>true</static><pose>1 2 0 0 0 1.5707963267948966</pose>"
      "<link name='l'><pose>1 0 0 0 0 0</pose><collision name='c'><pose>0 0 0.25 0 0 0</pose>"
      "<geometry><box><size>2 1 0.5</size></box></geometry></collision>"
      "<visual name='v'><geometry><box><size>2 1 0.5</size></box></geometry>"
      "<material><diffuse>0.2 0.4 0.6 1</diffuse></material></visual></link></model>");
  EXPECT_EQ(world.spec.name, "small");
  const WorldObject& box = named(world, "m/l/c");
  EXPECT_TRUE(box.T_map_object.translation().isApprox(Eigen::Vector3d(1.0, 3.0, 0.25), 1e-9));
  EXPECT_TRUE(box.T_map_object.linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-9));
  EXPECT_EQ(std::get<BoxShape>(box.shape).size, Eigen::Vector3d(2.0, 1.0, 0.5));
  EXPECT_TRUE(box.color.isApprox(Eigen::Vector3f(0.2F, 0.4F, 0.6F)));
  EXPECT_TRUE(world.spec.min_corner.isApprox(Eigen::Vector2d(0.5, 2.0), 1e-9));
  EXPECT_TRUE(world.spec.max_corner.isApprox(Eigen::Vector2d(1.5, 4.0), 1e-9));
  EXPECT_TRUE(world.warnings.empty());
}

/// Like turtlebot3_world: ground plane and lights are ignored, walls and pillars are in one model.
TEST_F(SdfFiles, ReadsAWorldOfPillars) {
  std::string pillars;
  for (int i = 0; i < 9; ++i) {
    pillars += "<collision name='p" + std::to_string(i) + "'><pose>" +
               std::to_string(1.1 * (i / 3 - 1)) + " " + std::to_string(1.1 * (i % 3 - 1)) +
               " 0.25 0 0 0</pose><geometry><cylinder><radius>0.15</radius><length>0.5</length>"
               "</cylinder></geometry></collision>";
  }
  for (int i = 0; i < 6; ++i) {
    const double angle = 1.0471975511965976 * i;
    pillars += "<collision name='w" + std::to_string(i) + "'><pose>" +
               std::to_string(2.5 * std::cos(angle)) + " " + std::to_string(2.5 * std::sin(angle)) +
               " 0.25 0 0 " + std::to_string(angle + 1.5707963267948966) +
               "</pose><geometry><box><size>2.95 0.1 0.5</size></box></geometry></collision>";
  }
  const SdfWorld world = load(
      "<light type='directional' name='sun'><direction>0 0 -1</direction></light>"
      "<plugin name='x' filename='libx.so'/>"
      "<physics type='ode'><max_step_size>0.001</max_step_size></physics>"
      "<model name='ground_plane'><static>1</static><link name='link'><collision name='c'>"
      "<geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry></collision>"
      "</link></model><model name='turtlebot3_world'><static>1</static><link name='symbol'>" +
      pillars + "</link></model>");
  EXPECT_EQ(world.spec.objects.size(), 15U);
  EXPECT_TRUE(world.warnings.empty());
  const Grid map = rasterise(world.spec, 0.2, 0.05);
  const auto free = std::count(map.cells.begin(), map.cells.end(), Cell::kFree);
  // A hexagon of in-radius 2.45 m less nine pillars.
  const double area = 2.0 * std::sqrt(3.0) * 2.45 * 2.45 - 9.0 * 3.14159 * 0.15 * 0.15;
  EXPECT_NEAR(static_cast<double>(free) * 0.0025, area, 0.07 * area);
}

/// Like aws-robomaker-small-house: models with a model.config and meshes.
TEST_F(SdfFiles, IncludesModelsWithMeshes) {
  put("models/chair/model.config",
      "<model><name>chair</name><sdf version='1.6'>chair.sdf</sdf></model>");
  put("models/chair/chair.sdf",
      "<sdf version='1.6'><model name='chair'><static>1</static>" +
          link("<mesh><uri>model://chair/meshes/c.obj</uri><scale>2 2 2</scale></mesh>") +
          "</model></sdf>");
  put("models/chair/meshes/c.obj",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
  const SdfWorld world = load(
      "<include><uri>model://chair</uri><name>one</name><pose>1 0 0 0 0 0</pose></include>"
      "<include><uri>model://chair</uri><name>two</name><pose>5 0 0 0 0 0</pose></include>");
  ASSERT_EQ(world.spec.objects.size(), 2U);
  const Eigen::AlignedBox3d box = bounds(named(world, "two/l/c"));
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(5.0, 0.0, 0.0), 1e-6));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(7.0, 2.0, 2.0), 1e-6));
}

TEST_F(SdfFiles, FindsModelsInSearchPaths) {
  put("elsewhere/crate/model.sdf", std::string("<sdf version='1.6'><model name='crate'><static>1"
                                               "</static>") +
                                       link(kBox, "0 0 0.25 0 0 0") + "</model></sdf>");
  const std::string file =
      put("worlds/w.sdf",
          "<sdf version='1.6'><world name='w'><include><uri>model://crate</uri></include></world>"
          "</sdf>");
  EXPECT_THROW(load_sdf(file, {}), std::runtime_error);
  EXPECT_EQ(load_sdf(file, {{(folder_ / "elsewhere").string()}}).spec.objects.size(), 1U);
  ::setenv("GZ_SIM_RESOURCE_PATH", (folder_ / "elsewhere").c_str(), 1);
  EXPECT_EQ(load_sdf(file, {}).spec.objects.size(), 1U);
  ::unsetenv("GZ_SIM_RESOURCE_PATH");
}

TEST_F(SdfFiles, ResolvesFramesAndNestedModels) {
  const std::string file = put("w.sdf",
                               "<sdf version='1.9'><world name='w'>"
                               "<frame name='desk'><pose>10 0 0 0 0 0</pose></frame>"
                               "<model name='a'><static>1</static>"
                               "<pose relative_to='desk'>1 0 0 0 0 0</pose>"
                               "<model name='b'><pose>0 1 0.25 0 0 0</pose>" +
                                   link(kBox) + "</model></model></world></sdf>");
  const SdfWorld world = load_sdf(file, {});
  const WorldObject& box = named(world, "a/b/l/c");
  EXPECT_TRUE(box.T_map_object.translation().isApprox(Eigen::Vector3d(11.0, 1.0, 0.25), 1e-9));
}

TEST_F(SdfFiles, SaysWhatItDoesNotTake) {
  const SdfWorld world =
      load("<model name='ball'>" + link("<sphere><radius>0.5</radius></sphere>", "0 0 0.5 0 0 0") +
           "</model><model name='roof'><static>1</static>" +
           link("<plane><normal>0 0 1</normal></plane>", "0 0 3 0 0 0") + "</model>");
  ASSERT_EQ(world.spec.objects.size(), 1U);
  ASSERT_EQ(world.warnings.size(), 2U);
  EXPECT_THAT(world.warnings[0], testing::HasSubstr("everything else lies below it: a plane"));
  EXPECT_THAT(world.warnings[1], testing::HasSubstr("not static, but treated as static: ball"));
}

/// Many worlds include sun and ground from the network; many have wrong masses.
TEST_F(SdfFiles, NeedsNeitherSunNorGroundNorMasses) {
  const SdfWorld world = load(
      "<include><uri>https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ground "
      "Plane</uri></include>"
      "<include><uri>model://sun</uri></include>"
      "<model name='m'><static>1</static><link name='l'><inertial><mass>1</mass><inertia>"
      "<ixx>0</ixx><iyy>0</iyy><izz>0</izz></inertia></inertial><collision name='c'><geometry>" +
      std::string(kBox) + "</geometry></collision></link></model>");
  EXPECT_EQ(world.spec.objects.size(), 1U);
  EXPECT_TRUE(world.warnings.empty());
}

TEST_F(SdfFiles, TakesFlatBoxesForFloor) {
  const SdfWorld world = load("<model name='floor'><static>1</static>" +
                              link("<box><size>50 50 0.1</size></box>", "0 0 -0.05 0 0 0") +
                              "</model><model name='box'><static>1</static>" +
                              link(kBox, "0 0 0.25 0 0 0") + "</model>");
  ASSERT_EQ(world.spec.objects.size(), 1U);
  EXPECT_EQ(world.spec.max_corner, Eigen::Vector2d(1.0, 0.5));
}

TEST_F(SdfFiles, LowersTheWorldToTheFloorThatTheStartIsOn) {
  const std::string slab = "<model name='slab'><static>1</static>" +
                           link("<box><size>8 6 0.1</size></box>", "0 0 0.05 0 0 0") +
                           "</model><model name='box'><static>1</static>" +
                           link(kBox, "2 0 0.35 0 0 0") + "</model>";
  const SdfWorld world = load(slab);
  EXPECT_NEAR(world.floor, 0.1, 1e-6);
  ASSERT_EQ(world.spec.objects.size(), 1U);
  EXPECT_NEAR(bounds(world.spec.objects.front()).min().z(), 0.0, 1e-6);
  ASSERT_EQ(world.warnings.size(), 1U);
  EXPECT_THAT(world.warnings[0], testing::HasSubstr("z = 0.100 m"));
  SdfOptions beside;
  beside.start = Eigen::Vector2d(30.0, 0.0);
  EXPECT_EQ(load_sdf((folder_ / "worlds/w.world").string(), beside).spec.objects.size(), 2U);
}

TEST_F(SdfFiles, TellsHowFarTheGroundGoes) {
  const std::string stone =
      "<model name='box'><static>1</static>" + link(kBox, "0 0 0.25 0 0 0") + "</model>";
  const SdfWorld world =
      load("<model name='g'><static>1</static><pose>1 0 0 0 0 0</pose>" +
           link("<plane><normal>0 0 1</normal><size>20 10</size></plane>") + "</model>" + stone);
  ASSERT_TRUE(world.ground.has_value());
  EXPECT_EQ(world.ground->extent.max(), Eigen::Vector2d(11.0, 5.0));
  EXPECT_FALSE(load(stone).ground.has_value());
  const SdfWorld included =
      load("<include><uri>model://ground_plane</uri><pose>0 0 -0.1 0 0 0</pose></include>" + stone);
  ASSERT_TRUE(included.ground.has_value());
  EXPECT_NEAR(included.floor, -0.1, 1e-9);
}

TEST_F(SdfFiles, LeavesOutWhatCannotBeRead) {
  const std::string good = "<model name='a'><static>1</static>" + link(kBox) + "</model>";
  const SdfWorld world = load(good + "<model name='hollow'></model>" +
                              "<include><uri>model://nobody</uri></include>" + good);
  EXPECT_EQ(world.spec.objects.size(), 2U);
  EXPECT_EQ(world.warnings.size(), 2U);
  SdfOptions strict;
  strict.strict = true;
  EXPECT_THROW(load_sdf((folder_ / "worlds/w.world").string(), strict), std::runtime_error);
}

TEST_F(SdfFiles, SaysInWordsWhatIsLeftOut) {
  const SdfWorld world =
      load("<model name='a'><static>1</static>" + link(kBox) + "</model>" +
           "<model name='b'><static>1</static>" +
           link("<polyline><point>0 0</point><point>1 0</point><point>1 1</point><height>1</height>"
                "</polyline>") +
           "</model><model name='sea'><static>1</static>" +
           link("<box><size>300000 300000 1</size></box>") +
           "</model><include><uri>model://nobody</uri></include>"
           "<include><uri>https://fuel.gazebosim.org/1.0/x/models/y</uri></include>");
  EXPECT_THAT(
      world.warnings,
      testing::UnorderedElementsAre(
          testing::StartsWith("left out, since it is not found in /"),
          testing::StartsWith("left out, since it is not on this machine; download"),
          "left out, since the geometry <polyline> is not supported: b/l/c",
          "left out, since it has a length of 300000 m: it must be above 0 and at most 10000 m: "
          "sea/l/c"));
}

TEST_F(SdfFiles, ReadsAWorldOfAReservedName) {
  const std::string file = put("hall.world",
                               "<sdf version='1.6'><world name='world'>"
                               "<model name='a'><static>1</static>" +
                                   link(kBox, "0 0 0.25 0 0 0") + "</model></world></sdf>");
  EXPECT_EQ(load_sdf(file, {}).spec.name, "hall");
}

TEST_F(SdfFiles, ReadsHundredsOfModels) {
  std::string models;
  for (int i = 0; i < 230; ++i) {
    models += "<model name='m" + std::to_string(i) + "'><static>1</static><pose>" +
              std::to_string(3 * i) + " 0 0.25 0 0 0</pose>" + link(kBox) + "</model>";
  }
  EXPECT_EQ(load(models).spec.objects.size(), 230U);
}

/// Like 3k_shapes of gz-sim: models spread over 1.5 km. Reading the models would give another
/// error.
TEST_F(SdfFiles, RefusesTensOfThousandsOfModelsBeforeTheyAreRead) {
  std::string models;
  for (int i = 0; i <= 10'000; ++i) {
    models += "<model name='m" + std::to_string(i) + "'>" + link(kBox) + "</model>";
  }
  try {
    load(models);
    ADD_FAILURE() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("10001 models: at most 10000 are read"));
  }
}

TEST_F(SdfFiles, RefusesAWorldOfKilometresBeforeItsModelsAreRead) {
  const std::string model = "<model name='a'><pose>-750 0 0 0 0 0</pose>" + link(kBox) +
                            "</model><model name='hollow'></model>";
  SdfOptions strict;
  strict.strict = true;
  const std::string file = put("w.sdf", "<sdf version='1.6'><world name='w'>" + model +
                                            "<model name='b'><pose>750 0 0 0 0 0"
                                            "</pose>" +
                                            link(kBox) + "</model></world></sdf>");
  try {
    load_sdf(file, strict);
    FAIL() << "it was read";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("1500 m x 0 m: at most 1000 m in each direction"));
  }
}

TEST_F(SdfFiles, FindsFilesBesideTheWorldsFolderInAnyLetterCase) {
  put("models/crate/meshes/Crate.OBJ",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
  for (const char* uri : {"file://models/crate/meshes/Crate.OBJ", "model://crate/meshes/crate.obj",
                          "file://models/crate/Meshes/Crate.obj"}) {
    const SdfWorld world =
        load("<model name='m'><static>1</static>" +
             link("<mesh><uri>" + std::string(uri) + "</uri></mesh>") + "</model>");
    EXPECT_EQ(world.spec.objects.size(), 1U) << uri;
  }
}

TEST_F(SdfFiles, ExpandsXacro) {
  const std::string file =
      put("w.sdf.xacro",
          "<sdf version='1.6' xmlns:xacro='http://ros.org/wiki/xacro'><world name='default'>"
          "<xacro:property name='w' value='2.0'/><model name='m'><static>1</static>" +
              link("<box><size>${w} ${w/2} 0.5</size></box>", "0 0 0.25 0 0 0") +
              "</model></world></sdf>");
  const SdfWorld world = load_sdf(file, {});
  EXPECT_EQ(world.spec.name, "w");
  EXPECT_EQ(std::get<BoxShape>(world.spec.objects.front().shape).size,
            Eigen::Vector3d(2.0, 1.0, 0.5));
}

TEST_F(SdfFiles, PutsSimplerShapesAboutCapsulesAndEllipsoids) {
  const std::string file =
      put("w.sdf",
          "<sdf version='1.9'><world name='w'><model name='m'><static>1</static>"
          "<link name='l'><pose>0 0 1 0 0 0</pose><collision name='c'><geometry><capsule>"
          "<radius>0.2</radius><length>1</length></capsule></geometry></collision>"
          "<collision name='e'><geometry><ellipsoid><radii>0.1 0.2 0.3</radii></ellipsoid>"
          "</geometry></collision></link></model></world></sdf>");
  const SdfWorld world = load_sdf(file, {});
  EXPECT_NEAR(std::get<CylinderShape>(named(world, "m/l/c").shape).height, 1.4, 1e-9);
  EXPECT_TRUE(std::get<BoxShape>(named(world, "m/l/e").shape)
                  .size.isApprox(Eigen::Vector3d(0.2, 0.4, 0.6), 1e-9));
  EXPECT_EQ(world.warnings.size(), 2U);
}

}  // namespace
}  // namespace castaway::sim
