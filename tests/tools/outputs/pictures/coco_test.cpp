#include "tools/outputs/pictures/coco.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/scene/scene.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint16_t kAda = sim::kFirstPersonInstance;
constexpr std::uint16_t kBob = sim::kFirstPersonInstance + 3;

/// 4 columns, 3 rows.
const std::vector<std::uint16_t> kPicture = {0, kAda, kAda, 0,  //
                                             0, kAda, 12,   0,  //
                                             1, 1,    1,    kBob};

TEST(MaskOf, CountsDownTheColumns) {
  const auto mask = mask_of(kPicture, 4, kAda);
  ASSERT_TRUE(mask.has_value());
  EXPECT_EQ(mask->left, 1);
  EXPECT_EQ(mask->top, 0);
  EXPECT_EQ(mask->width, 2);
  EXPECT_EQ(mask->height, 2);
  EXPECT_EQ(mask->area, 3);
  EXPECT_EQ(mask->counts, (std::vector<int>{3, 2, 1, 1, 5}));
}

TEST(MaskOf, BeginsWithWhatDoesNotBelong) {
  EXPECT_EQ(mask_of({kAda, 0}, 1, kAda)->counts, (std::vector<int>{0, 1, 1}));
  EXPECT_FALSE(mask_of(kPicture, 4, 99).has_value());
}

TEST(CocoFile, ListsPicturesAndThePeopleInThem) {
  CocoFile coco;
  coco.add("rgb/000000.png", 1.5, kPicture, 4);
  coco.add("rgb/000001.png", 2.0, std::vector<std::uint16_t>(12, 0), 4);
  const auto json = nlohmann::json::parse(coco.text());
  ASSERT_EQ(json["images"].size(), 2U);
  EXPECT_EQ(json["images"][0]["height"], 3);
  EXPECT_EQ(json["images"][1]["file_name"], "rgb/000001.png");
  ASSERT_EQ(json["annotations"].size(), 2U);
  const auto& bob = json["annotations"][1];
  EXPECT_EQ(bob["image_id"], json["images"][0]["id"]);
  EXPECT_EQ(bob["category_id"], json["categories"][0]["id"]);
  EXPECT_EQ(bob["bbox"], nlohmann::json({3, 2, 1, 1}));
  EXPECT_EQ(bob["person"], 3);
  EXPECT_EQ(bob["segmentation"]["size"], nlohmann::json({3, 4}));
}

}  // namespace
}  // namespace castaway::testbed
