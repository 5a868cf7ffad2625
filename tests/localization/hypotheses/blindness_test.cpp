#include "localization/hypotheses/blindness.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(Blindness, HalvesTheProbabilityInItsHalfLife) {
  Blindness blindness(30.0);
  blindness.take(from_seconds(1.0), 0);
  EXPECT_EQ(blindness.unmoved(), 1.0);  // It has never seen anything.
  blindness.take(from_seconds(2.0), 100);
  EXPECT_EQ(blindness.unmoved(), 1.0);
  blindness.take(from_seconds(32.0), 0);
  EXPECT_NEAR(blindness.unmoved(), 0.5, 1e-12);
  blindness.take(from_seconds(62.0), 0);
  EXPECT_NEAR(blindness.unmoved(), 0.25, 1e-12);
  blindness.take(from_seconds(63.0), 100);
  EXPECT_EQ(blindness.unmoved(), 1.0);
}

TEST(Blindness, IsNoneWhereTheViewFadedAway) {
  Blindness blindness(30.0);
  blindness.take(from_seconds(1.0), 3);
  blindness.take(from_seconds(31.0), 0);
  EXPECT_EQ(blindness.unmoved(), 1.0);
}

TEST(Blindness, IsForgottenAtAStart) {
  Blindness blindness(30.0);
  blindness.take(from_seconds(1.0), 100);
  blindness.take(from_seconds(31.0), 0);
  blindness.start();
  EXPECT_EQ(blindness.unmoved(), 1.0);
}

TEST(Blindness, WithoutAHalfLifeChangesNothing) {
  Blindness blindness(0.0);
  blindness.take(from_seconds(1.0), 100);
  blindness.take(from_seconds(1000.0), 0);
  EXPECT_EQ(blindness.unmoved(), 1.0);
}

}  // namespace
}  // namespace castaway::localization
