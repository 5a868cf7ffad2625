#include "tools/outputs/records/scan_row.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"

namespace castaway::testbed {
namespace {

std::shared_ptr<const LabelContext> context() {
  auto made = std::make_shared<LabelContext>();
  made->legend.entries[0] = {BeamClass::kStatic, "wall"};
  made->legend.entries[1] = {BeamClass::kUnmapped, "box"};
  made->legend.first_person = 100;
  made->ambiguity = {{{0.0, 0.0}, {1.0, 0.0}}, {0.25, 0.75}};
  return made;
}

TEST(ScanRow, LabelsEveryBeam) {
  ScanRecord record = record_at(2.0, {});
  record.truth.labels = {0, 1, 102, -1};
  const ScanRow row = ScanLabeller(context()).row_of(record);
  EXPECT_EQ(row.classes, (std::vector<std::uint8_t>{1, 2, 5, 0}));
  EXPECT_EQ(row.hits, (std::vector<std::int32_t>{0, 1, 2, -1}));
  EXPECT_EQ(row.occluded, 0.5);
  EXPECT_EQ(row.ambiguity, 0.25);
  EXPECT_EQ(ScanLabeller(context()).row_of(record_at(9.0, {})).ambiguity, 0.75);
  EXPECT_EQ(ScanLabeller(context()).row_of(record_at(9.0, {})).occluded, 0.0);
}

TEST(ScanRow, CountsTimeFromTheLastKidnap) {
  ScanLabeller labeller(context());
  EXPECT_FALSE(labeller.row_of(record_at(1.0, {})).since_kidnap_s);
  labeller.add(kidnap_to(1.5));
  labeller.add(kidnap_to(3.0));
  EXPECT_EQ(labeller.row_of(record_at(2.0, {})).since_kidnap_s, 0.5);
  EXPECT_EQ(labeller.row_of(record_at(3.0, {})).since_kidnap_s, 0.0);
  EXPECT_FALSE(labeller.row_of(record_at(3.0, {})).torn);
  RunEvent collision = kidnap_to(4.0);
  collision.what = sim::Collision{};
  labeller.add(collision);
  EXPECT_EQ(labeller.row_of(record_at(4.5, {})).since_kidnap_s, 1.5);
}

TEST(ScanRow, ATeleportWithinTheSweepTearsIt) {
  ScanLabeller labeller(context());
  labeller.add(kidnap_to(2.05));
  EXPECT_TRUE(labeller.row_of(record_at(2.0, {})).torn);
  EXPECT_FALSE(labeller.row_of(record_at(2.0, {})).held);
  EXPECT_FALSE(labeller.row_of(record_at(1.9, {})).torn);
  EXPECT_FALSE(labeller.row_of(record_at(2.1, {})).torn);
}

TEST(ScanRow, ARobotInTheAirIsHeld) {
  ScanLabeller labeller(context());
  RunEvent pick_up = kidnap_to(2.05);
  pick_up.what = sim::PickUp{};
  labeller.add(pick_up);
  EXPECT_TRUE(labeller.row_of(record_at(2.0, {})).torn);
  EXPECT_FALSE(labeller.row_of(record_at(2.0, {})).held);
  EXPECT_TRUE(labeller.row_of(record_at(2.1, {})).held);
  EXPECT_FALSE(labeller.row_of(record_at(2.1, {})).torn);
  RunEvent put_down = kidnap_to(4.02);
  put_down.since = pick_up.stamp;
  labeller.add(put_down);
  const ScanRow last = labeller.row_of(record_at(4.0, {}));
  EXPECT_TRUE(last.held);
  EXPECT_TRUE(last.torn);
  EXPECT_FALSE(labeller.row_of(record_at(4.1, {})).held);
}

TEST(RollPitchYaw, ComesBack) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  const Vector3d angles(0.3, -0.4, 2.5);
  const Eigen::Matrix3d rotation =
      (AngleAxisd(angles.z(), Vector3d::UnitZ()) * AngleAxisd(angles.y(), Vector3d::UnitY()) *
       AngleAxisd(angles.x(), Vector3d::UnitX()))
          .toRotationMatrix();
  EXPECT_NEAR((roll_pitch_yaw(rotation) - angles).norm(), 0.0, 1e-12);
  EXPECT_NEAR(roll_pitch_yaw(Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
}

TEST(ScanRow, ALocalizerIsLostFromHalfAMetreOn) {
  ScanRecord record = record_at(0.0, {"a", "b", "c"});  // errors of 0.2 m and 0.1 rad
  record.localizers[1].estimate->T_map_base = {0.3, 0.4, 0.0};
  record.localizers[2].estimate.reset();
  EXPECT_EQ(ScanLabeller(context()).row_of(record).lost, (std::vector<std::uint8_t>{0, 1, 1}));
  record.localizers[1].estimate->T_map_base = {0.0, 0.0, 0.35};
  EXPECT_TRUE(is_off(record.localizers[1], record));
  record.localizers[1].estimate->T_map_base = {0.0, 0.0, 0.34};
  EXPECT_FALSE(is_off(record.localizers[1], record));
}

}  // namespace
}  // namespace castaway::testbed
