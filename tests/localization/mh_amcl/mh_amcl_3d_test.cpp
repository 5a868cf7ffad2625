/// MH-AMCL on a 3-D map: over floors and ramps.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "localization/mh_amcl/ground_motion.hpp"
#include "localization/mh_amcl/mh_amcl.hpp"
#include "tests/localization/space/map3d/building.hpp"

namespace castaway::localization {
namespace {

constexpr double kTick = 0.1;  // [s]

/// A robot that drives from waypoint to waypoint, with perfect odometry.
class BuildingDrive {
 public:
  BuildingDrive(const test::Building& building, const SE2& T_atlas_start)
      : building_(building), truth_(T_atlas_start) {}

  /// Drives for a tick towards a point in map; true when it is there.
  bool step(Localizer& localizer, const Eigen::Vector2d& target) {
    const Eigen::Vector2d p_base = in_map().inverse() * target;
    const double turn = std::atan2(p_base.y(), p_base.x());
    const double ahead = std::abs(turn) < 0.5 ? 0.5 : 0.0;
    tell(localizer, {ahead * kTick, 0.0, std::clamp(2.0 * turn, -1.0, 1.0) * kTick});
    return p_base.norm() < 0.3;
  }
  /// Drives for a tick wherever there is room, and turns elsewhere.
  void wander(Localizer& localizer) {
    tell(localizer, has_room_ ? SE2{0.5 * kTick, 0.0, 0.0} : SE2{0.0, 0.0, 0.8 * kTick});
  }
  /// Stands still for a tick under a cloth.
  void stand_covered(Localizer& localizer) {
    now_ += from_seconds(kTick);
    localizer.on_odometry({now_, T_odom_base_});
    LaserScan scan = building_.laser_scan(truth_, kBeams, rng_);
    scan.stamp = now_;
    std::fill(scan.ranges.begin(), scan.ranges.end(), std::numeric_limits<float>::infinity());
    localizer.on_scan(scan);
  }
  /// Moves the robot elsewhere, unnoticed.
  void kidnap(const SE2& T_atlas_base) { truth_ = T_atlas_base; }

  [[nodiscard]] SE2 in_map() const { return building_.volume().atlas().in_map(truth_); }
  [[nodiscard]] TerrainPose pose() const { return *building_.volume().lift(truth_); }

 private:
  void tell(Localizer& localizer, const SE2& u) {
    move(u);
    now_ += from_seconds(kTick);
    localizer.on_odometry({now_, T_odom_base_});
    LaserScan scan = building_.laser_scan(truth_, kBeams, rng_);
    scan.stamp = now_;
    localizer.on_scan(scan);
    has_room_ = building_.volume().lift(truth_ * SE2{0.5, 0.0, 0.0}).has_value();
    for (int i = -kBeams / 10; has_room_ && i <= kBeams / 10; ++i) {
      has_room_ = scan.ranges[static_cast<std::size_t>((i + kBeams) % kBeams)] > 0.7F;
    }
  }
  void move(const SE2& u) {
    const SE2 step = along_ground(ground_, truth_, u);
    truth_ = building_.volume().atlas().on_own_chart(truth_ * step);
    T_odom_base_ = T_odom_base_ * u;
  }

  static constexpr int kBeams = 180;

  const test::Building& building_;
  /// Does not own the volume.
  Ground ground_ =
      SpaceMap{std::shared_ptr<const Volume>(std::shared_ptr<void>(), &building_.volume())};
  SE2 truth_;
  bool has_room_ = false;
  SE2 T_odom_base_;
  Stamp now_ = from_seconds(1.0);
  Rng rng_ = substream(1, "drive");
};

/// From the lower floor over the ramp to the upper one.
const std::vector<Eigen::Vector2d> kWayUp{
    {-10.9, 3.0}, {-10.9, 6.9}, {4.0, 7.0}, {7.5, 7.0}, {7.5, 5.5}};

double error_of(const Localizer& localizer, const BuildingDrive& drive) {
  const auto estimate = localizer.estimate();
  return estimate ? distance(estimate->T_map_base, drive.in_map()) : 1e9;
}

bool is_right(const Localizer& localizer, const BuildingDrive& drive) {
  const auto estimate = localizer.estimate();
  return estimate && !estimate->lost && error_of(localizer, drive) < 0.15 && estimate->footing &&
         estimate->footing->level == drive.pose().level;
}

class MhAmcl3dBeliefs : public testing::TestWithParam<const char*> {
 protected:
  /// The defaults, normal distributions that are refined on cells, or particles that are weighed
  /// along beams.
  static MhAmclConfig config() {
    const std::string kind = GetParam();
    MhAmclConfig config;
    if (kind == "AlongBeams") config.track_by = TrackingError::kAlongBeam;
    if (kind != "Gaussians") return config;
    config.belief = BeliefKind::kGaussians;
    config.refine_by = RefineMethod::kNdtPoints;
    return config;
  }
};

INSTANTIATE_TEST_SUITE_P(All, MhAmcl3dBeliefs,
                         testing::Values("Particles", "Gaussians", "AlongBeams"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(MhAmcl3dBeliefs, TracksFromFloorToFloor) {
  Rng rng = substream(1, "mh_amcl_3d");
  const test::Building building(rng, 6);
  MhAmcl localizer(std::make_shared<const MhAmclModels>(config(), building.shared()), 1);
  const SE2 start{-8.0, 3.0, 3.1};
  localizer.initialize(PoseWithCovariance{
      start, Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal().toDenseMatrix(), 0.0});
  BuildingDrive drive(building, *building.volume().atlas().to_atlas(start, 0.0));
  double worst = 0.0;
  double worst_z = 0.0;
  for (const Eigen::Vector2d& target : kWayUp) {
    for (int tick = 0; !drive.step(localizer, target); ++tick) {
      ASSERT_LT(tick, 1000);
      worst = std::max(worst, error_of(localizer, drive));
      ASSERT_TRUE(localizer.estimate()->footing);
      worst_z = std::max(worst_z, std::abs(localizer.estimate()->footing->z -
                                           drive.pose().T_map_base.translation().z()));
    }
  }
  EXPECT_LT(worst, 0.15);
  EXPECT_LT(worst_z, 0.05);
  EXPECT_EQ(localizer.estimate()->footing->level, 1);
  EXPECT_NEAR(localizer.estimate()->footing->z, 3.0, 0.02);
  EXPECT_FALSE(localizer.estimate()->lost);
}

/// Number of drives of 10 s, from random places, at whose end the localizer is right.
int found_after(int drives, const MhAmclConfig& config, const test::Building& building, Rng& rng) {
  const auto models = std::make_shared<const MhAmclModels>(config, building.shared());
  int found = 0;
  for (int i = 0; i < drives; ++i) {
    MhAmcl localizer(models, static_cast<std::uint64_t>(i));
    localizer.initialize(std::nullopt);
    BuildingDrive drive(building, building.sample(rng));
    for (int tick = 0; tick < 100; ++tick) drive.wander(localizer);
    found += is_right(localizer, drive) ? 1 : 0;
  }
  return found;
}

TEST_P(MhAmcl3dBeliefs, FindsItselfOnAnyFloorAndRamp) {
  Rng rng = substream(2, "mh_amcl_3d");
  int found = 0;
  for (int i = 0; i < 2; ++i) found += found_after(5, config(), test::Building(rng, 8), rng);
  EXPECT_EQ(found, 10);
}

TEST(MhAmcl3d, RecoversFromAKidnapToAnotherFloor) {
  Rng rng = substream(3, "mh_amcl_3d");
  const test::Building building(rng, 8);
  const Atlas& atlas = building.volume().atlas();
  MhAmcl localizer(std::make_shared<const MhAmclModels>(MhAmclConfig{}, building.shared()), 1);
  BuildingDrive drive(building, *atlas.to_atlas({7.5, 6.5, 0.0}, 3.0));
  for (int tick = 0; tick < 60; ++tick) drive.wander(localizer);
  EXPECT_TRUE(is_right(localizer, drive));
  EXPECT_EQ(drive.pose().level, 1);
  drive.kidnap(*atlas.to_atlas({-8.0, 5.5, 0.0}, 0.0));
  for (int tick = 0; tick < 100; ++tick) drive.wander(localizer);
  EXPECT_TRUE(is_right(localizer, drive));
  EXPECT_EQ(drive.pose().level, 0);
}

TEST(MhAmcl3d, WhereItSeesNothingItVouchesForNothing) {
  Rng rng = substream(5, "mh_amcl_3d");
  const test::Building building(rng, 8);
  const auto models = std::make_shared<const MhAmclModels>(config_on_3d_maps(), building.shared());
  MhAmcl localizer(models, 1);
  BuildingDrive drive(building, *building.volume().atlas().to_atlas({-8.0, 5.5, 0.0}, 0.0));
  for (int tick = 0; tick < 60; ++tick) drive.wander(localizer);
  ASSERT_TRUE(is_right(localizer, drive));
  const double seen = localizer.estimate()->probability;
  for (int tick = 0; tick < 10; ++tick) drive.stand_covered(localizer);
  EXPECT_FALSE(localizer.estimate()->lost);
  for (int tick = 0; tick < 290; ++tick) drive.stand_covered(localizer);
  EXPECT_TRUE(localizer.estimate()->lost);
  EXPECT_NEAR(localizer.estimate()->probability, 0.5 * seen, 0.01);
  for (int tick = 0; tick < 10; ++tick) drive.wander(localizer);
  EXPECT_TRUE(is_right(localizer, drive));
}

TEST(MhAmcl3d, AStartBesideTheGroundIsMovedOntoIt) {
  Rng rng = substream(4, "mh_amcl_3d");
  const test::Building building(rng, 0);
  MhAmcl localizer(std::make_shared<const MhAmclModels>(MhAmclConfig{}, building.shared()), 1);
  localizer.initialize(PoseWithCovariance{{-30.0, 3.03, 0.4}});
  const auto populations = localizer.diagnostics().populations;
  ASSERT_EQ(populations.size(), 1U);
  EXPECT_NEAR(populations[0].T_map_base.x, -11.8, 0.3);
  EXPECT_NEAR(populations[0].T_map_base.y, 3.03, 0.06);
  EXPECT_EQ(populations[0].T_map_base.yaw, 0.4);
  EXPECT_TRUE(populations[0].footing);
}

}  // namespace
}  // namespace castaway::localization
