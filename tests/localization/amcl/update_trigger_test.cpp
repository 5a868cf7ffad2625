#include "localization/amcl/update_trigger.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

UpdateTrigger updated_at_origin() {
  UpdateTrigger trigger{AmclConfig{}};  // 0.25 m, 0.2 rad
  EXPECT_TRUE(trigger.take_turn("front", {}));
  trigger.note_update({});
  return trigger;
}

TEST(UpdateTrigger, AwaitsEveryScanBeforeTheFirstUpdate) {
  UpdateTrigger trigger{AmclConfig{}};
  EXPECT_FALSE(trigger.updated_at());
  EXPECT_TRUE(trigger.take_turn("front", {}));
  EXPECT_TRUE(trigger.take_turn("front", {}));
}

TEST(UpdateTrigger, AwaitsMotionAlongAnAxisOrATurn) {
  EXPECT_FALSE(updated_at_origin().take_turn("front", {0.25, -0.25, 0.2}));
  EXPECT_TRUE(updated_at_origin().take_turn("front", {0.26, 0.0, 0.0}));
  EXPECT_TRUE(updated_at_origin().take_turn("front", {0.0, -0.26, 0.0}));
  EXPECT_TRUE(updated_at_origin().take_turn("front", {0.0, 0.0, -0.21}));
}

TEST(UpdateTrigger, AwaitsOneScanOfEveryLidarAfterMotion) {
  UpdateTrigger trigger = updated_at_origin();
  EXPECT_TRUE(trigger.take_turn("rear", {}));  // Its first scan.
  EXPECT_FALSE(trigger.take_turn("rear", {}));
  const SE2 moved{1.0, 0.0, 0.0};
  EXPECT_TRUE(trigger.take_turn("front", moved));
  trigger.note_update(moved);
  EXPECT_EQ(trigger.updated_at(), moved);
  EXPECT_FALSE(trigger.take_turn("front", moved));
  EXPECT_TRUE(trigger.take_turn("rear", moved));
  EXPECT_FALSE(trigger.take_turn("rear", moved));
}

TEST(UpdateTrigger, AwaitsEveryScanAfterAResetOrAtRestIfConfigured) {
  UpdateTrigger trigger = updated_at_origin();
  EXPECT_FALSE(trigger.take_turn("front", {}));
  trigger.reset();
  EXPECT_FALSE(trigger.updated_at());
  EXPECT_TRUE(trigger.take_turn("front", {}));
  AmclConfig config;
  config.update_at_rest = true;
  UpdateTrigger at_rest(config);
  at_rest.note_update({});
  EXPECT_TRUE(at_rest.take_turn("front", {}));
  EXPECT_TRUE(at_rest.take_turn("front", {}));
}

}  // namespace
}  // namespace castaway::localization
