#include "localization/filter/recovery_averages.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(RecoveryAverages, StartAtTheFirstWeightAndFollow) {
  RecoveryAverages averages({0.1, 0.5});
  averages.add(1.0);
  EXPECT_DOUBLE_EQ(averages.random_share(), 0.0);
  // slow 1 + 0.1 * (0.2 - 1) = 0.92, fast 1 + 0.5 * (0.2 - 1) = 0.6; 1 - 0.6 / 0.92 = 0.347826
  averages.add(0.2);
  EXPECT_NEAR(averages.random_share(), 0.347826, 1e-6);
  // slow 0.92 - 0.1 * 0.72 = 0.848, fast 0.6 - 0.5 * 0.4 = 0.4; 1 - 0.4 / 0.848 = 0.528302
  averages.add(0.2);
  EXPECT_NEAR(averages.random_share(), 0.528302, 1e-6);
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
