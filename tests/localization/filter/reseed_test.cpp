#include "localization/filter/reseed.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

ParticleSet line(int count) {
  ParticleSet particles;
  for (int i = 0; i < count; ++i) particles.poses.push_back({static_cast<double>(i), 0.0, 0.0});
  particles.log_weights.assign(particles.poses.size(), 0.0);
  return particles;
}

TEST(Reseed, KeepsTheWinnersAndDropsTheLosers) {
  ParticleSet particles = line(4);
  particles.log_weights = {-100.0, 0.0, 0.0, -100.0};
  Rng rng = substream(1, "reseed");
  const ParticleSet next = reseed(particles, 10, std::nullopt, rng);
  ASSERT_EQ(next.size(), 10U);
  for (const SE2& pose : next.poses) EXPECT_TRUE(pose.x == 1.0 || pose.x == 2.0);
  EXPECT_EQ(std::count(next.poses.begin(), next.poses.end(), SE2{1.0, 0.0, 0.0}), 5);
}

TEST(Reseed, DrawsTheRestAroundTheWinner) {
  ParticleSet particles = line(4);
  particles.log_weights = {-100.0, 0.0, 0.0, -100.0};  // half of them have all the weight
  Rng rng = substream(1, "reseed");
  const PoseGaussian winner({7.0, 0.0, 0.0}, Eigen::Matrix3d::Zero());
  const ParticleSet next = reseed(particles, 10, winner, rng);
  EXPECT_EQ(std::count(next.poses.begin(), next.poses.end(), SE2{7.0, 0.0, 0.0}), 5);
  EXPECT_EQ(next.log_weights, std::vector<double>(10, 0.0));
}

TEST(ParticleCount, GrowsWithTheSpread) {
  const ReseedConfig config{50, 200, 0.3, 0.5};
  EXPECT_EQ(particle_count(config, Eigen::Matrix3d::Zero()), 50);
  EXPECT_EQ(particle_count(config, Eigen::Vector3d(0.0225, 0.0225, 0.0).asDiagonal()), 125);
  EXPECT_EQ(particle_count(config, Eigen::Vector3d(9.0, 9.0, 0.0).asDiagonal()), 200);
}

TEST(ReseedConfig, RefusesFiguresOutOfRange) {
  EXPECT_THROW(validate(ReseedConfig{1, 200, 0.3, 0.5}), std::invalid_argument);
  EXPECT_THROW(validate(ReseedConfig{50, 40, 0.3, 0.5}), std::invalid_argument);
  EXPECT_THROW(validate(ReseedConfig{50, 200, 0.3, 0.5, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
