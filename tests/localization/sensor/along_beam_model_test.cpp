#include "localization/sensor/along_beam_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "localization/matching/refine.hpp"
#include "localization/space/map3d/survey_ground.hpp"
#include "localization/space/map3d/voxel_builder.hpp"

namespace castaway::localization {
namespace {

constexpr double kSigma = 0.05;
const EndpointConfig kModel{kSigma, 0.05, 30.0};

constexpr double kLow = 0.03;    // [m] Walls x = kLow and y = kLow.
constexpr double kWide = 8.03;   // [m] x of the opposite wall.
constexpr double kDeep = 6.03;   // [m] y of the opposite wall.
constexpr double kLidar = 0.4;   // [m] Its height.
constexpr double kHeight = 3.0;  // [m] Of the walls.

/// A room with a floor at 0.
Volume room() {
  constexpr double kFine = 0.02;
  VoxelBuilder builder(0.1);
  for (double x = kLow; x < kWide; x += kFine) {
    for (double y = kLow; y < kDeep; y += kFine) builder.add({x, y, 0.0});
    for (double z = 0.0; z < kHeight; z += kFine) {
      builder.add({x, kLow, z}, false);
      builder.add({x, kDeep, z}, false);
    }
  }
  for (double y = kLow; y < kDeep; y += kFine) {
    for (double z = 0.0; z < kHeight; z += kFine) {
      builder.add({kLow, y, z}, false);
      builder.add({kWide, y, z}, false);
    }
  }
  VoxelMap voxels = builder.build();
  ElevationMap ground = survey_ground(voxels, GroundConfig{});
  return {std::move(voxels), std::move(ground), VolumeConfig{}};
}

/// Length of a ray from `from` to the first wall of the room, or its floor.
double length_to_surface(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  double length = 1e9;
  const auto meet = [&](double distance, double rate) {
    if (rate > 1e-9) length = std::min(length, distance / rate);
  };
  meet(kWide - from.x(), direction.x());
  meet(from.x() - kLow, -direction.x());
  meet(kDeep - from.y(), direction.y());
  meet(from.y() - kLow, -direction.y());
  meet(from.z(), -direction.z());
  return length;
}

/// A robot in the room.
class AlongBeam : public testing::Test {
 protected:
  /// Beams in rings that end `by` [m] behind the surfaces.
  [[nodiscard]] ScanPoints scan(double by) const {
    ScanPoints points;
    const Eigen::Isometry3d T_map_base = to_se3(pose_);
    const Eigen::Vector3d lidar(0.0, 0.0, kLidar);
    for (const double elevation : {-0.2, -0.1, 0.0, 0.1}) {
      for (int i = 0; i < 120; ++i) {
        const double azimuth = 0.0524 * i;
        const Eigen::Vector3d along(std::cos(azimuth) * std::cos(elevation),
                                    std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
        const double length = length_to_surface(T_map_base * lidar, T_map_base.linear() * along);
        append_beam(points, Eigen::Isometry3d(Eigen::Translation3d(lidar)), (length + by) * along);
      }
    }
    return points;
  }

  Volume room_ = room();
  AlongBeamModel model_{kModel, room_};
  SE2 pose_ = *room_.atlas().to_atlas({3.0, 2.2, 0.3}, 0.0);
};

/// Share of the errors that are this one, to 2 cm.
double share_of(const std::vector<float>& errors, double expected) {
  const auto count = std::count_if(errors.begin(), errors.end(), [&](float error) {
    return std::abs(static_cast<double>(error) - expected) < 0.02;
  });
  return static_cast<double>(count) / static_cast<double>(errors.size());
}

TEST_F(AlongBeam, TheErrorIsHowMuchTooLongOrTooShortTheBeamIs) {
  for (const double by : {-0.1, -0.05, 0.0, 0.05, 0.1}) {
    const std::vector<float> errors = model_.errors(scan(by), pose_);
    ASSERT_EQ(errors.size(), 480U);
    EXPECT_GT(share_of(errors, std::abs(by)), 0.9) << by;
  }
}

TEST_F(AlongBeam, ASlantedBeamIsFartherFromItsWallThanItsEndIs) {
  const ScanPoints points = scan(0.1);
  const std::vector<float> errors = model_.errors(points, pose_);
  const PoseInVolume pose(room_.lift(pose_)->T_map_base);
  int slanted = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float distance = room_.surfaces().at(pose.end(points, i));
    EXPECT_GE(errors[i], std::min(distance, model_.reach()) - 0.012F);
    slanted += errors[i] > distance + 0.03F ? 1 : 0;
  }
  EXPECT_GT(slanted, 50);
}

TEST_F(AlongBeam, BeyondThreeSigmaThereIsNoSurface) {
  EXPECT_NEAR(model_.reach(), 3.0 * kSigma, 1e-6);
  EXPECT_GT(share_of(model_.errors(scan(-0.3), pose_), 3.0 * kSigma), 0.9);
  for (const float error : model_.errors(scan(-0.3), {100.0, 0.0, 0.0})) {
    EXPECT_EQ(error, model_.reach());
  }
}

TEST_F(AlongBeam, TheLikelihoodIsThatOfTheErrors) {
  for (const int count : {1, 3, 4, 7, 200}) {
    const ScanPoints points = thin(scan(0.04), count);
    const std::vector<float> errors = model_.errors(points, pose_);
    const std::vector<float> beams = model_.beam_log_likelihoods(points, pose_);
    double sum = 0.0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      EXPECT_NEAR(beams[i], endpoint_log_likelihood(kModel, static_cast<double>(errors[i])), 0.02);
      sum += static_cast<double>(beams[i]);
    }
    EXPECT_NEAR(model_.log_likelihood(points, pose_), 30.0 * sum / count, 1e-3);
  }
  EXPECT_EQ(model_.log_likelihood(ScanPoints{}, pose_), 0.0);
}

TEST_F(AlongBeam, TheRightPoseIsLikelierThanThoseBesideIt) {
  const ScanPoints points = scan(0.0);
  const double right = model_.log_likelihood(points, pose_);
  for (const Eigen::Vector3d& step :
       {Eigen::Vector3d(0.06, 0.0, 0.0), Eigen::Vector3d(-0.06, 0.0, 0.0),
        Eigen::Vector3d(0.0, 0.06, 0.0), Eigen::Vector3d(0.0, -0.06, 0.0),
        Eigen::Vector3d(0.0, 0.0, 0.03), Eigen::Vector3d(0.0, 0.0, -0.03)}) {
    EXPECT_GT(right, model_.log_likelihood(points, offset(pose_, step)) + 0.5) << step.transpose();
  }
}

TEST_F(AlongBeam, RefusesFiguresOutOfRange) {
  EXPECT_THROW(AlongBeamModel({0.0, 0.1, 1.0}, room_), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
