#include "localization/filter/correct.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "localization/geometry/transform_buffer.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

/// Prefers poses far to the right.
struct Rightwards {
  double log_likelihood(const ScanPoints& points, const SE2& T_map_base) const {
    return T_map_base.x * static_cast<double>(points.size());
  }
};

TEST(Correct, AddsTheLogLikelihoodOfEveryParticle) {
  ParticleSet particles;
  particles.poses = {{1.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}};
  particles.log_weights = {0.0, -1.0};
  correct(particles, Rightwards{}, test::forward_beams({1.0F, 2.0F, 3.0F}));
  EXPECT_DOUBLE_EQ(particles.log_weights[0], 3.0);
  EXPECT_DOUBLE_EQ(particles.log_weights[1], -7.0);
}

/// A map that is not planar: only a beam under the ceiling, above x = 4 m, from 2 m up.
struct CeilingBeam {
  double log_likelihood(const ScanPoints& points, const SE2& T_map_base) const {
    const Eigen::Isometry3d T = to_se3(T_map_base);
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d p = T * Eigen::Vector3d(points.x[i], points.y[i], points.z[i]);
      sum -= std::hypot(p.x() - 4.0, std::min(0.0, p.z() - 2.0)) / 0.1;
    }
    return sum;
  }
};

TEST(Correct, WeighsByAMapThatIsNotPlanar) {
  // A lidar 0.5 m above base that looks up by 45 degrees hits the beam's edge if base is 1.5 m in
  // front of it: 1.5 m ahead, 1.5 m up.
  LaserScan scan;
  scan.angle_min = 0.0;
  scan.angle_increment = 0.1;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  scan.ranges = {static_cast<float>(1.5 * std::numbers::sqrt2)};
  scan.T_base_laser = Eigen::Translation3d(0.0, 0.0, 0.5) *
                      Eigen::AngleAxisd(-std::numbers::pi / 4.0, Eigen::Vector3d::UnitY());
  TransformBuffer T_odom_base;
  T_odom_base.add(Stamp(0), {});
  const ScanPoints points = *project_scan(scan, T_odom_base, Stamp(0), {});
  ASSERT_EQ(points.size(), 1U);
  EXPECT_NEAR(points.z[0], 2.0, 1e-6);
  EXPECT_NEAR(points.origin_z[0], 0.5, 1e-6);
  ParticleSet particles;
  particles.poses = {{2.0, 0.0, 0.0}, {2.5, 0.0, 0.0}, {2.5, 0.0, std::numbers::pi}};
  particles.log_weights = {0.0, 0.0, 0.0};
  correct(particles, CeilingBeam{}, points);
  EXPECT_NEAR(particles.log_weights[0], -5.0, 1e-5);
  EXPECT_NEAR(particles.log_weights[1], 0.0, 1e-5);
  EXPECT_NEAR(particles.log_weights[2], -30.0, 1e-5);
}

}  // namespace
}  // namespace castaway::localization
