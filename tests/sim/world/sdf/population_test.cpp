#include "sim/world/sdf/population.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

PopulationPlaces placed_by(const std::string& inside) {
  const auto document = parse_xml("w.sdf", "<population>" + inside + "</population>");
  Rng rng(7);
  return place_population(*document->RootElement(), rng);
}

std::string box(const std::string& type, int count, const std::string& pose = "10 0 0 0 0 0") {
  return "<pose>" + pose + "</pose><box><size>4 2 1</size></box><model_count>" +
         std::to_string(count) + "</model_count><distribution><type>" + type +
         "</type></distribution>";
}

std::string cylinder(const std::string& type, int count) {
  return "<pose>0 5 0 0 0 0</pose><cylinder><radius>2</radius><length>1</length></cylinder>"
         "<model_count>" +
         std::to_string(count) + "</model_count><distribution><type>" + type +
         "</type></distribution>";
}

TEST(Population, StandsInARowAlongAnAxis) {
  const PopulationPlaces row = placed_by(box("linear-x", 4));
  ASSERT_EQ(row.p_world.size(), 4U);
  EXPECT_FALSE(row.drawn);
  EXPECT_TRUE(row.p_world[0].isApprox(Eigen::Vector3d(8.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(row.p_world[3].isApprox(Eigen::Vector3d(11.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(
      placed_by(box("linear-y", 2)).p_world[0].isApprox(Eigen::Vector3d(10.0, -1.0, 0.0), 1e-12));
  EXPECT_TRUE(
      placed_by(box("linear-z", 2)).p_world[1].isApprox(Eigen::Vector3d(10.0, 0.0, 0.0), 1e-12));
}

/// As in Gazebo, the box is shifted before, not after, it is turned.
TEST(Population, IsTurnedAboutItsPose) {
  const PopulationPlaces row = placed_by(box("linear-x", 2, "0 0 0 0 0 1.5707963267948966"));
  EXPECT_TRUE(row.p_world[0].isApprox(Eigen::Vector3d(-3.0, -1.0, 0.0), 1e-9));
  EXPECT_TRUE(row.p_world[1].isApprox(Eigen::Vector3d(-3.0, 1.0, 0.0), 1e-9));
}

TEST(Population, StaysInItsRegionWhereItIsDrawn) {
  for (const char* type : {"random", "uniform"}) {
    const PopulationPlaces in_box = placed_by(box(type, 30));
    ASSERT_EQ(in_box.p_world.size(), 30U);
    EXPECT_TRUE(in_box.drawn);
    for (const Eigen::Vector3d& p : in_box.p_world) {
      EXPECT_LE(std::abs(p.x() - 10.0), 2.0);
      EXPECT_LE(std::abs(p.y()), 1.0);
      EXPECT_LE(std::abs(p.z()), 0.5);
    }
    for (const Eigen::Vector3d& p : placed_by(cylinder(type, 30)).p_world) {
      EXPECT_LE((p.head<2>() - Eigen::Vector2d(0.0, 5.0)).norm(), 2.0);
      EXPECT_TRUE(p.z() >= 0.0 && p.z() <= 1.0);
    }
  }
}

TEST(Population, IsSpreadIfUniform) {
  const PopulationPlaces places = placed_by(box("uniform", 8));
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GT((places.p_world[i] - places.p_world[k]).head<2>().norm(), 0.5);
    }
  }
}

TEST(Population, IsRefusedIfGazeboWouldIgnoreIt) {
  EXPECT_THROW(placed_by(box("ring", 3)), std::runtime_error);
  EXPECT_THROW(placed_by(box("random", 0)), std::runtime_error);
  EXPECT_THROW(placed_by(box("random", 30000)), std::runtime_error);
  EXPECT_THROW(placed_by(cylinder("linear-x", 3)), std::runtime_error);
  EXPECT_THROW(placed_by("<distribution><type>random</type></distribution>"), std::runtime_error);
  EXPECT_THROW(placed_by("<distribution><type>grid</type><rows>200</rows><cols>200</cols>"
                         "<step>1 1 1</step></distribution>"),
               std::runtime_error);
}

}  // namespace
}  // namespace castaway::sim
