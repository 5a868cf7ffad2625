/// What Gazebo classic writes into its worlds.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/world/footprint.hpp"
#include "tests/sim/world/sdf/sdf_files.hpp"

namespace castaway::sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A folder of worlds with a wall and other models.
class ClassicWorlds : public SdfFiles {
 protected:
  static std::string model(const std::string& name, const std::string& pose,
                           const std::string& inside = link(kBox)) {
    return "<model name='" + name + "'><static>1</static><pose>" + pose + "</pose>" + inside +
           "</model>";
  }
  SdfWorld load_with(const std::string& more) {
    return load(model("wall", "0 4 0.25 0 0 0") + more);
  }
};

/// Such a joint made libsdformat throw a type that is no std::exception.
TEST_F(ClassicWorlds, HaveFlattenedNames) {
  const SdfWorld world = load_with(
      "<model name='bucket'><static>1</static><pose>1 1 0.25 0 0 0</pose>"
      "<link name='inner::body'><pose>0 1 0 0 0 0</pose><collision name='c'><geometry>" +
      std::string(kBox) +
      "</geometry></collision></link><joint name='inner::j' type='fixed'><parent>world</parent>"
      "<child>inner::body</child></joint></model>");
  EXPECT_TRUE(named(world, "bucket/inner/body/c")
                  .T_map_object.translation()
                  .isApprox(Eigen::Vector3d(1.0, 2.0, 0.25), 1e-9));
  EXPECT_TRUE(world.warnings.empty());
}

TEST_F(ClassicWorlds, MayIncludeModelsWithFlattenedNames) {
  put("models/bucket/model.sdf",
      "<sdf version='1.6'><model name='bucket'><static>1</static><link name='inner::body'>"
      "<collision name='c'><geometry>" +
          std::string(kBox) +
          "</geometry></collision></link><joint name='inner::j' type='fixed'>"
          "<parent>world</parent><child>inner::body</child></joint></model></sdf>");
  const SdfWorld world =
      load_with("<include><uri>model://bucket</uri><pose>1 1 0.25 0 0 0</pose></include>");
  EXPECT_TRUE(named(world, "bucket/inner/body/c")
                  .T_map_object.translation()
                  .isApprox(Eigen::Vector3d(1.0, 1.0, 0.25), 1e-9));
}

TEST_F(ClassicWorlds, AreAsTheFirstStateSays) {
  const SdfWorld world = load_with(
      model("box", "2 1 0.25 0 0 0") + model("pair", "0 0 0.25 0 0 0") +
      "<state world_name='w'><model name='box'><pose>-2 -1 0.25 0 0 1.5707963267948966</pose>"
      "<scale>1 1 1</scale></model><model name='pair'><pose>7 7 0.25 0 0 0</pose>"
      "<link name='l'><pose>-3 1 0.25 0 0 3.141592653589793</pose></link></model></state>"
      "<state world_name='w'><model name='box'><pose>9 9 9 0 0 0</pose></model></state>");
  const Eigen::Isometry3d& box = named(world, "box/l/c").T_map_object;
  EXPECT_TRUE(box.translation().isApprox(Eigen::Vector3d(-2.0, -1.0, 0.25), 1e-9));
  EXPECT_TRUE(box.linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-9));
  const Eigen::Isometry3d& pair = named(world, "pair/l/c").T_map_object;
  EXPECT_TRUE(pair.translation().isApprox(Eigen::Vector3d(-3.0, 1.0, 0.25), 1e-9));
  EXPECT_TRUE(pair.linear().col(0).isApprox(-Eigen::Vector3d::UnitX(), 1e-9));
}

TEST_F(ClassicWorlds, NameWhatTheirStatePlacesAndTheyDoNotHave) {
  const SdfWorld world =
      load_with("<include><uri>model://sun</uri></include>" + model("box", "2 1 0.25 0 0 0") +
                "<state world_name='w'><model name='box'><pose>1 1 0.25 0 0 0</pose>"
                "<link name='l'><pose>1 1 0.25 0 0 0</pose></link></model>"
                "<model name='sun'><pose>0 0 9 0 0 0</pose></model>"
                "<model name='bxo'><pose>0 0 0 0 0 0</pose><link name='l'/></model></state>");
  EXPECT_THAT(world.warnings,
              ElementsAre("its <state> places models that the world does not have: bxo"));
}

TEST_F(ClassicWorlds, ScaleModels) {
  const auto scaled = [](const std::string& name) {
    return "<model name='" + name + "'><pose>0 0 1 0 0 0</pose><scale>2 3 4</scale></model>";
  };
  put("models/m/c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
  const SdfWorld world =
      load_with(model("box", "0 0 1 0 0 0") +
                model("can", "0 0 1 0 0 0",
                      link("<cylinder><radius>0.1</radius><length>0.2</length></cylinder>")) +
                model("ball", "0 0 1 0 0 0", link("<sphere><radius>0.1</radius></sphere>")) +
                model("mesh", "0 0 1 0 0 0",
                      link("<mesh><uri>model://m/c.obj</uri><scale>5 5 5</scale></mesh>")) +
                "<state world_name='w'>" + scaled("box") + scaled("can") + scaled("ball") +
                scaled("mesh") + "</state>");
  EXPECT_TRUE(std::get<BoxShape>(named(world, "box/l/c").shape)
                  .size.isApprox(Eigen::Vector3d(4.0, 3.0, 2.0), 1e-9));
  EXPECT_NEAR(std::get<CylinderShape>(named(world, "can/l/c").shape).radius, 0.3, 1e-9);
  EXPECT_NEAR(std::get<CylinderShape>(named(world, "can/l/c").shape).height, 0.8, 1e-9);
  EXPECT_NEAR(std::get<SphereShape>(named(world, "ball/l/c").shape).radius, 0.4, 1e-9);
  EXPECT_EQ(std::get<MeshShape>(named(world, "mesh/l/c").shape).scale,
            Eigen::Vector3d(2.0, 3.0, 4.0));
}

TEST_F(ClassicWorlds, InsertAndDeleteModels) {
  const SdfWorld world =
      load_with(model("old", "2 1 0.25 0 0 0") + "<state world_name='w'><insertions>" +
                model("new", "5 1 0.25 0 0 0") +
                "</insertions><deletions><name>old</name></deletions></state>");
  ASSERT_EQ(world.spec.objects.size(), 2U);
  EXPECT_NEAR(named(world, "new/l/c").T_map_object.translation().x(), 5.0, 1e-9);
}

TEST_F(ClassicWorlds, MoveIncludedAndNestedModelsAndFarOnes) {
  put("models/crate/model.sdf", "<sdf version='1.6'><model name='crate'><static>1</static>" +
                                    link(kBox, "0 0 0.25 0 0 0") + "</model></sdf>");
  const SdfWorld world = load_with(
      "<include><uri>model://crate</uri><pose>1 0 0 0 0 0</pose></include>" +
      model("far", "5000 0 0.25 0 0 0") +
      model("outer", "3 0 0 0 0 0", "<model name='in'>" + link(kBox) + "</model>") +
      "<state world_name='w'><model name='crate'><pose>-1 0 0 0 0 0</pose></model>"
      "<model name='far'><pose>2 0 0.25 0 0 0</pose></model><model name='outer'>"
      "<pose>3 0 0 0 0 0</pose><model name='in'><pose>4 -2 0.25 0 0 0</pose></model></model>"
      "</state>");
  EXPECT_NEAR(named(world, "crate/l/c").T_map_object.translation().x(), -1.0, 1e-9);
  EXPECT_NEAR(named(world, "far/l/c").T_map_object.translation().x(), 2.0, 1e-9);
  EXPECT_TRUE(named(world, "outer/in/l/c")
                  .T_map_object.translation()
                  .isApprox(Eigen::Vector3d(4.0, -2.0, 0.25), 1e-9));
}

TEST_F(ClassicWorlds, HavePopulations) {
  const SdfWorld world = load_with(
      "<population name='cans'><model name='can'><static>1</static><pose>9 9 9 0 0 0</pose>" +
      link(kBox) +
      "</model><pose>1 2 0.25 0 0 0</pose><distribution><type>grid</type><rows>2</rows>"
      "<cols>3</cols><step>4 5 0</step></distribution></population>"
      "<population name='dice'><model name='die'><static>1</static>" +
      link(kBox) +
      "</model><pose>0 0 0.25 0 0 0</pose><box><size>4 6 0.01</size></box>"
      "<model_count>5</model_count><distribution><type>random</type></distribution></population>"
      "<population name='odd'><model name='x'/><box><size>4 6 1</size></box>"
      "<model_count>5</model_count><distribution><type>ring</type></distribution></population>");
  EXPECT_EQ(world.spec.objects.size(), 12U);
  EXPECT_TRUE(named(world, "can_clone_0/l/c")
                  .T_map_object.translation()
                  .isApprox(Eigen::Vector3d(-3.0, -0.5, 0.25), 1e-9));
  EXPECT_TRUE(named(world, "can_clone_5/l/c")
                  .T_map_object.translation()
                  .isApprox(Eigen::Vector3d(5.0, 4.5, 0.25), 1e-9));
  EXPECT_LE(std::abs(named(world, "die_clone_4/l/c").T_map_object.translation().y()), 3.0);
  EXPECT_THAT(world.warnings,
              testing::UnorderedElementsAre(
                  HasSubstr("anew at each start, here they are the same in every run: dice"),
                  HasSubstr("its distribution 'ring' over a box is none of Gazebo's: odd")));
}

TEST_F(ClassicWorlds, AreToldInOneLineWhatDoesNotCollide) {
  const std::string seen = "<link name='l'><visual name='v'><geometry>" + std::string(kBox) +
                           "</geometry></visual></link>";
  const SdfWorld world =
      load_with("<actor name='walker'/><actor name='runner'/>" + model("a", "0 0 0 0 0 0", seen) +
                model("b", "0 0 0 0 0 0", seen));
  EXPECT_EQ(world.spec.objects.size(), 1U);
  EXPECT_THAT(world.warnings,
              ElementsAre("left out, since only what collides is read: 2 actors "
                          "(walker, runner), 2 links with visuals only (a/l, b/l)"));
}

}  // namespace
}  // namespace castaway::sim
