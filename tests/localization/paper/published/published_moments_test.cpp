#include "localization/paper/published/published_moments.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

using std::numbers::pi;

PublishedDefects with(bool PublishedDefects::*defect) {
  PublishedDefects defects;
  defects.*defect = true;
  return defects;
}

TEST(PublishedMoments, AreThePapersWithoutDefects) {
  const ParticleSet particles{{{0, 0, 3.0}, {1, 2, -3.0}}, {0.0, -1.0}};
  const PoseMoments m = published_moments(particles, {});
  EXPECT_EQ(m.mean, moments(particles).mean);
  EXPECT_EQ(m.covariance, moments(particles).covariance);
}

TEST(PublishedMoments, IgnoreTheWeightsInTheCovariance) {
  const ParticleSet particles{{{0, 0, 0}, {2, 0, 0}}, {std::log(0.9), std::log(0.1)}};
  EXPECT_NEAR(published_moments(particles, {}).covariance(0, 0), 0.9 * 0.04 + 0.1 * 3.24, 1e-12);
  const PoseMoments m =
      published_moments(particles, with(&PublishedDefects::unweighted_covariance));
  EXPECT_NEAR(m.covariance(0, 0), 2.0, 1e-12);  // (1 + 1) / (2 - 1) about x = 1
  EXPECT_NEAR(m.mean.x, 0.2, 1e-12);            // the mean keeps its weights
}

TEST(PublishedMoments, DoNotWrapTheYaw) {
  const ParticleSet particles{{{0, 0, pi - 0.1}, {0, 0, 0.1 - pi}}, {0.0, 0.0}};
  EXPECT_NEAR(published_moments(particles, {}).covariance(2, 2), 0.01, 1e-12);
  const PoseMoments m = published_moments(particles, with(&PublishedDefects::unwrapped_yaw));
  const double far = 2.0 * pi - 0.1;  // error of one of the two particles, whichever side of
                                      // pi the mean is on
  EXPECT_NEAR(m.covariance(2, 2), (0.01 + far * far) / 2.0, 1e-9);
}

}  // namespace
}  // namespace castaway::localization
