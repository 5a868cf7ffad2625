#include "localization/sensor/scan_agreement.hpp"

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

}  // namespace
}  // namespace castaway::localization
