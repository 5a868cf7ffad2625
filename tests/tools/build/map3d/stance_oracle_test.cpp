// How a robot stands on a 3-D map, held against the simulator: it is put down and comes to rest.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"
#include "sim/robot/bodies/robot_physics.hpp"
#include "sim/robot/load_robot.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/build/map3d/run_volume.hpp"
#include "tools/build/map3d/survey_world.hpp"

namespace castaway::testbed {
namespace {

using localization::SE2;

constexpr int kCells = 30;     // Of the meadow's mesh, along an edge.
constexpr double kCell = 0.3;  // [m]
constexpr int kPlaces = 200;

double hills(double x, double y) {
  return 1.0 + 0.15 * std::sin(1.1 * x) * std::cos(0.9 * y + 0.5) + 0.06 * std::sin(2.0 * x + y);
}

std::string meadow_obj() {
  std::string text;
  for (int y = 0; y <= kCells; ++y) {
    for (int x = 0; x <= kCells; ++x) {
      text += fmt::format("v {} {} {}\n", x * kCell, y * kCell, hills(x * kCell, y * kCell));
    }
  }
  const auto vertex = [](int x, int y) { return y * (kCells + 1) + x + 1; };
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      text +=
          fmt::format("f {} {} {}\nf {} {} {}\n", vertex(x, y), vertex(x + 1, y),
                      vertex(x + 1, y + 1), vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1));
    }
  }
  return text;
}

sim::SimulationConfig mule_on_a_meadow(const std::string& mesh) {
  sim::SimulationConfig config;
  config.world.name = "meadow";
  config.world.min_corner = {0.0, 0.0};
  config.world.max_corner = {kCells * kCell, kCells * kCell};
  sim::WorldObject ground;
  ground.name = "ground";
  ground.shape = sim::MeshShape{mesh};
  ground.drivable = true;
  config.world.objects = {ground};
  config.robot = sim::load_robot(CASTAWAY_SOURCE_DIR "/robots/mule/mule.urdf.xacro");
  return config;
}

/// What the map says of how a robot stands, against how it does.
struct StanceError {
  double tilt = 0.0;    ///< [rad]
  double height = 0.0;  ///< [m]
};

StanceError stance_error(const localization::Volume& volume, const Eigen::Isometry3d& T_map_base) {
  const Eigen::Vector3d p = T_map_base.translation();
  const double yaw = std::atan2(T_map_base(1, 0), T_map_base(0, 0));
  const auto pose = volume.lift(volume.atlas().to_atlas({p.x(), p.y(), yaw}, p.z()).value());
  const Eigen::Isometry3d T_stated_base = pose.value().T_map_base.inverse() * T_map_base;
  return {Eigen::AngleAxisd(T_stated_base.linear()).angle(),
          std::abs(pose->T_map_base.translation().z() - p.z())};
}

std::vector<StanceError> stance_errors(const localization::Volume& volume,
                                       const std::vector<Eigen::Isometry3d>& at_rest) {
  std::vector<StanceError> errors;
  for (const auto& T_map_base : at_rest) errors.push_back(stance_error(volume, T_map_base));
  return errors;
}

/// The share of the errors below a limit.
template <typename Member>
double share_below(const std::vector<StanceError>& errors, Member member, double limit) {
  const auto below = std::ranges::count_if(
      errors, [&](const StanceError& error) { return error.*member < limit; });
  return static_cast<double>(below) / static_cast<double>(errors.size());
}

/// Where a robot is 0.8 s after it has been put down 2 cm above the ground.
std::vector<Eigen::Isometry3d> poses_at_rest(const sim::SimulationConfig& config,
                                             const localization::Volume& volume) {
  sim::RobotPhysics physics(config.world, config.robot, {}, {0.4, 1.0, 0.5, 2.0},
                            std::chrono::milliseconds(2));
  localization::Rng random = localization::substream(3, "places");
  boost::random::uniform_real_distribution<double> within(1.0, kCells * kCell - 1.0);
  boost::random::uniform_real_distribution<double> yaw(-3.1, 3.1);
  std::vector<Eigen::Isometry3d> poses;
  for (int place = 0; place < kPlaces; ++place) {
    const SE2 planar{within(random), within(random), yaw(random)};
    const auto pose = volume.lift(volume.atlas().to_atlas(planar, 1.0).value());
    physics.place(Eigen::Translation3d(0.0, 0.0, 0.02) * pose.value().T_map_base);
    for (int i = 0; i < 400; ++i) physics.step();
    poses.push_back(physics.state().T_map_base);
  }
  return poses;
}

TEST(StanceOracle, IsWhereTheSimulatedRobotComesToRest) {
  const TemporaryFolder folder;
  sim::SimulationConfig config = mule_on_a_meadow(folder.put("meadow.obj", meadow_obj()));
  Map3dOptions options;
  options.start = {4.5, 4.5, hills(4.5, 4.5)};
  const auto known = std::make_shared<const Map3d>(survey_world(config.world, options));
  const auto volume = volume_of(config, known)(0.1);
  const auto at_rest = poses_at_rest(config, *volume);
  config.robot.wheels.clear();
  config.robot.casters.clear();
  const auto errors = stance_errors(*volume, at_rest);
  const auto without_wheels = stance_errors(*volume_of(config, known)(0.1), at_rest);
  const double half_a_degree = 0.5 * M_PI / 180.0;
  EXPECT_GT(share_below(errors, &StanceError::tilt, half_a_degree), 0.7);
  EXPECT_LT(share_below(without_wheels, &StanceError::tilt, half_a_degree), 0.6);
  EXPECT_GT(share_below(errors, &StanceError::height, 0.0025), 0.9);
  EXPECT_LT(share_below(without_wheels, &StanceError::height, 0.0025), 0.7);
}

}  // namespace
}  // namespace castaway::testbed
