#include "localization/filter/recovery_averages.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(RecoveryAverages, StartAtTheFirstWeightAndFollow) {
  RecoveryAverages averages({0.1, 0.5});
  averages.add(1.0);
  EXPECT_DOUBLE_EQ(averages.random_share(), 0.0);
  averages.add(0.2);  // slow 0.92, fast 0.6
  EXPECT_NEAR(averages.random_share(), 1.0 - 0.6 / 0.92, 1e-12);
}

TEST(RecoveryAverages, NeverAskForParticlesWhenThingsImprove) {
  RecoveryAverages averages({0.1, 0.5});
  averages.add(0.2);
  averages.add(1.0);
  EXPECT_EQ(averages.random_share(), 0.0);
}

TEST(RecoveryAverages, AreOffByDefault) {
  RecoveryAverages averages({});
  averages.add(1.0);
  averages.add(0.01);
  EXPECT_EQ(averages.random_share(), 0.0);
}

TEST(RecoveryAverages, StartAnewAfterAReset) {
  RecoveryAverages averages({0.1, 0.5});
  averages.add(1.0);
  averages.add(0.1);
  averages.reset();
  averages.add(0.1);
  EXPECT_EQ(averages.random_share(), 0.0);
}

}  // namespace
}  // namespace castaway::localization
