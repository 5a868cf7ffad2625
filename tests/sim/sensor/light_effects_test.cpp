#include "sim/sensor/light_effects.hpp"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

TEST(LightEffects, AreOffByDefault) {
  EXPECT_FALSE(any(LightEffects{}));
  EXPECT_EQ(lost_share({}, 1.0, 0.1, 0.05), 0.0);
  EXPECT_EQ(seen_within({}, 0.1, 0.01), std::numeric_limits<double>::infinity());
}

TEST(LightEffects, DropOutGoesWithRangeSquared) {
  LightEffects effects;
  effects.dropout_far = 0.4;
  EXPECT_TRUE(any(effects));
  EXPECT_DOUBLE_EQ(lost_share(effects, 1.0, 1.0, 1.0), 0.4);
  EXPECT_DOUBLE_EQ(lost_share(effects, 0.5, 1.0, 1.0), 0.1);
}

TEST(LightEffects, DropOutGoesWithIncidenceAndDarkness) {
  LightEffects effects;
  effects.dropout_grazing = 0.5;
  EXPECT_DOUBLE_EQ(lost_share(effects, 0.0, 0.25, 1.0), 0.375);
  effects.dropout_grazing = 0.0;
  effects.dropout_dark = 0.5;
  EXPECT_DOUBLE_EQ(lost_share(effects, 0.0, 1.0, 0.2), 0.4);
}

TEST(LightEffects, CausesOfLossAreIndependent) {
  LightEffects effects;
  effects.dropout = 0.1;
  effects.dropout_far = 0.2;
  effects.dropout_grazing = 0.5;
  effects.dropout_dark = 0.4;
  EXPECT_DOUBLE_EQ(lost_share(effects, 1.0, 0.5, 0.5), 1.0 - 0.9 * 0.8 * 0.75 * 0.8);
}

TEST(LightEffects, DarkThingsAreSeenAsFarAsTheirLightReaches) {
  LightEffects effects;
  effects.dark_range = 4.0;
  EXPECT_DOUBLE_EQ(seen_within(effects, 1.0, 0.1), 4.0);
  EXPECT_DOUBLE_EQ(seen_within(effects, 1.0, 0.9), 12.0);
  EXPECT_DOUBLE_EQ(seen_within(effects, 0.25, 0.1), 2.0);
  EXPECT_EQ(seen_within(effects, 1.0, 0.0), 0.0);
}

TEST(LightEffects, NameTheFieldThatIsWrong) {
  LightEffects effects;
  effects.dropout_far = 1.5;
  try {
    validate(effects);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("noise.dropout_far is 1.5: give a share"));
  }
}

}  // namespace
}  // namespace castaway::sim
