#include "tools/build/scene/person_model.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "sim/people/bodies/person_visuals.hpp"
#include "tests/tools/support/base64.hpp"

namespace castaway::testbed {
namespace {

Eigen::AlignedBox3f bounds_of(const nlohmann::ordered_json& mesh) {
  const std::string bytes = from_base64(mesh.at("positions").get<std::string>());
  Eigen::AlignedBox3f box;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::array<float, 3>)) {
    std::array<float, 3> p{};
    std::memcpy(p.data(), bytes.data() + at, sizeof p);
    box.extend(Eigen::Vector3f(p[0], p[1], p[2]));
  }
  return box;
}

std::array<std::uint8_t, 3> first_color(const nlohmann::ordered_json& mesh) {
  const std::string bytes = from_base64(mesh.at("colors").get<std::string>());
  std::array<std::uint8_t, 3> color{};
  std::memcpy(color.data(), bytes.data(), sizeof color);
  return color;
}

TEST(PersonModel, PartsAreWhereTheyBelong) {
  const auto json = person_json({}).at("near");
  const auto shoe = bounds_of(json.at("shoe"));
  EXPECT_NEAR(shoe.min().z(), 0.0F, 1e-6F);
  EXPECT_LT(shoe.max().z(), 0.15F);
  EXPECT_GT(shoe.max().x(), -shoe.min().x());  // Toes are ahead.
  const auto shin = bounds_of(json.at("shin"));
  EXPECT_NEAR(shin.min().z(), 0.0F, 1e-6F);
  EXPECT_NEAR(shin.max().z(), sim::kTorsoBottom + 0.07, 1e-5);
  EXPECT_NEAR(shin.sizes().x(), 0.14F, 1e-3F);
  const auto thigh = bounds_of(json.at("thigh"));
  EXPECT_NEAR(thigh.min().z(), 0.0F, 1e-6F);
  EXPECT_NEAR(thigh.max().z(), 1.0F, 1e-6F);
  const auto coat = bounds_of(json.at("coat"));
  EXPECT_NEAR(coat.min().z(), sim::kTorsoBottom, 1e-5);
  EXPECT_NEAR(coat.sizes().y(), 2 * sim::kTorsoHalfWidth, 3e-3);  // Arms have nine sides.
  const auto head = bounds_of(json.at("head"));
  EXPECT_NEAR(head.max().z(), sim::PersonBody{}.height, 0.03);
  EXPECT_GT(head.min().z(), coat.max().z() - 0.1F);
}

TEST(PersonModel, WhoIsFarAwayIsCoarse) {
  const auto json = person_json({});
  const auto size = [&](const char* distance, const char* part) {
    return json.at(distance).at(part).at("indices").get<std::string>().size();
  };
  for (const char* part : {"shin", "thigh", "coat", "head"}) {
    EXPECT_LT(2 * size("far", part), size("near", part) * 5 / 4) << part;
  }
  EXPECT_EQ(size("far", "shoe"), size("near", "shoe"));
}

TEST(PersonModel, WhatClothesColorIsWhite) {
  const auto json = person_json({}).at("far");
  const std::array<std::uint8_t, 3> white{255, 255, 255};
  EXPECT_EQ(first_color(json.at("shin")), white);
  EXPECT_EQ(first_color(json.at("coat")), white);
  EXPECT_NE(first_color(json.at("head")), white);
}

TEST(PersonModel, ClothesAreThoseOfThePictures) {
  const auto json = person_json({});
  ASSERT_EQ(json.at("clothes").size(), 18U);
  for (const int number : {0, 7, 17, 18, 40}) {
    const auto& clothes = json.at("clothes").at(static_cast<std::size_t>(number) % 18);
    const auto items = sim::person_visuals({}, {}, number);
    const auto worn = [&](std::size_t part) {
      const auto& c = clothes.at(part);
      const Eigen::Vector3f color(c.at(0).get<float>(), c.at(1).get<float>(), c.at(2).get<float>());
      return std::any_of(items.begin(), items.end(),
                         [&](const sim::SceneItem& item) { return item.color == color; });
    };
    EXPECT_TRUE(worn(0) && worn(1)) << number;
    EXPECT_NE(clothes.at(0), clothes.at(1));
  }
}

}  // namespace
}  // namespace castaway::testbed
