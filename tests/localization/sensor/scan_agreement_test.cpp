#include "localization/sensor/scan_agreement.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class ScanAgreementTest : public testing::Test {
 protected:
  ScanPoints scan_from(const SE2& pose) const { return test::points_from(office_, pose); }
  double agreement(const SE2& first, const SE2& second, const SE2& T_odom_step) const {
    return scan_agreement({}, scan_from(first), scan_from(second), T_odom_step).value();
  }
  OccupancyGrid office_ = test::office();
  SE2 pose_{3.0, 3.0, 0.4};
};

TEST_F(ScanAgreementTest, IsCompleteForASmoothStep) {
  EXPECT_GT(agreement(pose_, pose_, {}), 0.98);
  const SE2 step{0.4, 0.0, 0.3};
  EXPECT_GT(agreement(pose_, pose_ * step, step), 0.9);
}

TEST_F(ScanAgreementTest, IsLowAfterAKidnap) {
  EXPECT_LT(agreement(pose_, {8.0, 6.0, 1.9}, {}), 0.65);
  EXPECT_LT(agreement(pose_, pose_ * SE2{0.0, 0.0, 1.5}, {}), 0.65);
}

TEST_F(ScanAgreementTest, DoesNotCountWhatOneScanHidesFromTheOther) {
  // A person stands close in front of the second scan; its other beams agree as before.
  ScanPoints crowded = scan_from(pose_);
  for (std::size_t i = 0; i < crowded.size() / 4; ++i) {
    const float scale = 0.5F / crowded.range[i];
    crowded.x[i] *= scale;
    crowded.y[i] *= scale;
    crowded.range[i] = 0.5F;
  }
  const double share = scan_agreement({}, scan_from(pose_), crowded, {}).value();
  // The rays pass the near points (a quarter of one scan); the points that they hide are not
  // counted.
  EXPECT_NEAR(share, 1.5 / 1.75, 0.03);
}

TEST_F(ScanAgreementTest, SaysNothingOfScansWithoutACommonView) {
  EXPECT_FALSE(scan_agreement({}, {}, scan_from(pose_), {}));
  EXPECT_FALSE(scan_agreement({}, scan_from(pose_), {}, {}));
  ScanPoints few = scan_from(pose_);
  for (auto* v : {&few.x, &few.y, &few.z, &few.origin_x, &few.origin_y, &few.origin_z, &few.range})
    v->resize(5);
  EXPECT_FALSE(scan_agreement({}, few, few, {}));
}

/// Adds a point in direction `angle` of base.
void add_beam(ScanPoints& points, double angle, double range) {
  points.x.push_back(static_cast<float>(range * std::cos(angle)));
  points.y.push_back(static_cast<float>(range * std::sin(angle)));
  points.range.push_back(static_cast<float>(range));
  for (auto* v : {&points.z, &points.origin_x, &points.origin_y, &points.origin_z}) v->push_back(0);
}

/// Moves the points, and the place that they were seen from, in base.
void move(ScanPoints& points, const Eigen::Vector2d& by) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    points.x[i] += static_cast<float>(by.x());
    points.y[i] += static_cast<float>(by.y());
    points.origin_x[i] += static_cast<float>(by.x());
    points.origin_y[i] += static_cast<float>(by.y());
  }
}

TEST(ScanAgreement, IsTheSameInEveryDirection) {
  for (int degree = -180; degree <= 180; degree += 1) {
    const double yaw = degree * std::numbers::pi / 180.0;
    ScanPoints before;
    ScanPoints after;
    // A sector of 21 beams; between them 20 beams of which the two in the middle are shorter.
    for (int k = -10; k <= 10; ++k) add_beam(before, yaw + 0.1 * k, 2.0);
    for (int k = -10; k < 10; ++k) {
      add_beam(after, yaw + 0.1 * k + 0.05, k == -1 || k == 0 ? 1.0 : 2.0);
    }
    // 18 of 20 agree with what `before` saw. Of its beams 19 lie between those of `after`; the
    // short ones hide one of them.
    EXPECT_NEAR(scan_agreement({}, before, after, {}).value(), (18.0 + 18.0) / (20.0 + 18.0), 1e-12)
        << degree;
  }
}

/// The lidar stays where it is while base turns about it by a quarter: the counts are those of
/// beams from its own place.
TEST(ScanAgreement, IsThatOfTheLidarsPlaceOffBasesOrigin) {
  const Eigen::Vector2d lidar(-0.2, 0.5);
  const SE2 turn{0.0, 0.0, 0.5 * std::numbers::pi};
  const Eigen::Vector2d shift = lidar - turn * lidar;
  const SE2 T_before_now{shift.x(), shift.y(), 0.5 * std::numbers::pi};
  for (int degree = -180; degree <= 180; degree += 15) {
    const double yaw = degree * std::numbers::pi / 180.0;
    ScanPoints before;
    ScanPoints now;
    for (int k = -10; k <= 10; ++k) add_beam(before, yaw + 0.1 * k, 2.0);
    for (int k = -10; k < 10; ++k) {
      const double angle = yaw + 0.1 * k + 0.05 - 0.5 * std::numbers::pi;
      add_beam(now, angle, k == -1 || k == 0 ? 1.0 : 2.0);
    }
    move(before, lidar);
    move(now, lidar);
    EXPECT_NEAR(scan_agreement({}, before, now, T_before_now).value(), 36.0 / 38.0, 1e-12)
        << degree;
  }
}

}  // namespace
}  // namespace castaway::localization
