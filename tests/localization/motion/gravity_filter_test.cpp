#include "localization/motion/gravity_filter.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

constexpr double kG = 9.81;

/// Feeds 100 Hz.
class Feed {
 public:
  void hold(double seconds, const Eigen::Vector3d& force, double rate_y = 0.0) {
    for (int i = 0; i < static_cast<int>(std::lround(100.0 * seconds)); ++i) {
      now_ += std::chrono::milliseconds(10);
      filter.add(now_, {0.0, rate_y, 0.0}, force);
    }
  }
  GravityFilter filter;

 private:
  Stamp now_{};
};

/// Force at rest with the nose up by an angle. [rad]
Eigen::Vector3d nose_up(double angle) { return {kG * std::sin(angle), 0.0, kG * std::cos(angle)}; }

TEST(GravityFilter, KnowsUpAfterAMoment) {
  Feed feed;
  EXPECT_FALSE(feed.filter.up());
  feed.hold(0.1, nose_up(0.1));
  EXPECT_FALSE(feed.filter.up());
  feed.hold(0.3, nose_up(0.1));
  ASSERT_TRUE(feed.filter.up());
  EXPECT_NEAR((*feed.filter.up() - nose_up(0.1).normalized()).norm(), 0.0, 1e-9);
}

TEST(GravityFilter, FollowsTheGyroOntoARamp) {
  Feed feed;
  feed.hold(2.0, nose_up(0.0));
  // Half a second of turning nose up; the rate about y is negative.
  for (int i = 1; i <= 50; ++i) feed.hold(0.01, nose_up(0.003 * i), -0.3);
  ASSERT_TRUE(feed.filter.up());
  EXPECT_NEAR((*feed.filter.up() - nose_up(0.15).normalized()).norm(), 0.0, 0.01);
}

TEST(GravityFilter, DoesNotTakeAShortAccelerationForARamp) {
  Feed feed;
  feed.hold(2.0, nose_up(0.0));
  feed.hold(0.3, {1.5, 0.0, kG});
  const Eigen::Vector3d up = feed.filter.up().value_or(Eigen::Vector3d::UnitZ());
  EXPECT_LT((up - Eigen::Vector3d::UnitZ()).norm(), 0.05);
  feed.hold(0.5, nose_up(0.0));
  ASSERT_TRUE(feed.filter.up());
  EXPECT_LT((*feed.filter.up() - Eigen::Vector3d::UnitZ()).norm(), 0.05);
}

/// A kidnap that the gyro does not feel.
TEST(GravityFilter, DoubtsAndThenTakesNewGround) {
  Feed feed;
  feed.hold(2.0, nose_up(0.0));
  feed.hold(0.3, nose_up(0.15));
  EXPECT_FALSE(feed.filter.up());
  feed.hold(1.5, nose_up(0.15));
  ASSERT_TRUE(feed.filter.up());
  EXPECT_NEAR((*feed.filter.up() - nose_up(0.15).normalized()).norm(), 0.0, 0.01);
}

TEST(GravityFilter, DropsWhatIsNotFiniteOrOld) {
  Feed feed;
  feed.hold(1.0, nose_up(0.1));
  const Eigen::Vector3d before = *feed.filter.up();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  feed.filter.add(std::chrono::seconds(2), {nan, 0.0, 0.0}, nose_up(0.0));
  feed.filter.add(std::chrono::seconds(2), {0.0, 0.0, 0.0}, {0.0, nan, 0.0});
  feed.filter.add(std::chrono::seconds(2), {0.0, 0.0, 0.0}, Eigen::Vector3d::Zero());
  feed.filter.add(std::chrono::milliseconds(500), {0.0, 0.0, 0.0}, nose_up(-0.3));
  EXPECT_EQ(*feed.filter.up(), before);
  feed.filter.clear();
  EXPECT_FALSE(feed.filter.up());
}

}  // namespace
}  // namespace castaway::localization
