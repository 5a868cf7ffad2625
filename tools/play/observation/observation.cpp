#include "tools/play/observation/observation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "localization/input/sensor_input.hpp"
#include "localization/map/hollow.hpp"
#include "localization/mh_amcl/mh_amcl_config.hpp"
#include "localization/sensor/along_beam_model.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/map3d/run_volume.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/build/scene/visible_scene.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/play/observation/cell_mesh.hpp"
#include "tools/play/observation/observation_colors.hpp"

namespace castaway::testbed {
namespace {

const Eigen::Vector3f kOccupiedColor{0.16F, 0.22F, 0.36F};
const Eigen::Vector3f kUnknownColor{0.72F, 0.72F, 0.72F};

Eigen::Vector3f color_of(const CostMap& map, const localization::EndpointConfig& model,
                         std::size_t cell) {
  switch (map.grid.cells[cell]) {
    case localization::CellState::kOccupied:
      return kOccupiedColor;
    case localization::CellState::kUnknown:
      return kUnknownColor;
    default:
      return cost_color(model, static_cast<double>(map.distances.values()[cell]));
  }
}

using localization::EndpointModel;
using localization::MhAmcl3dConfig;
using localization::MhAmclConfig;
using localization::ScanPoints;
using localization::Volume;

constexpr double kSettle = 1.0;  // [s] A robot that was put down stands still.

/// The settings of the first `mh_amcl` of a scenario, or the defaults on its kind of map.
MhAmcl3dConfig localizer_of(const Scenario& scenario, bool on_3d_map) {
  for (const LocalizerSpec& spec : scenario.localizers) {
    if (const auto* planar = std::get_if<MhAmclConfig>(&spec.config)) return {*planar};
    if (const auto* volume = std::get_if<MhAmcl3dConfig>(&spec.config)) return *volume;
  }
  return on_3d_map ? MhAmcl3dConfig{} : MhAmcl3dConfig{MhAmclConfig{}};
}

/// True if the first `mh_amcl` works on a 3-D map.
bool is_3d(const Scenario& scenario) {
  for (const LocalizerSpec& spec : scenario.localizers) {
    if (std::holds_alternative<MhAmclConfig>(spec.config)) return false;
    if (std::holds_alternative<MhAmcl3dConfig>(spec.config)) return true;
  }
  return false;
}

/// A scan as the localizer takes it.
struct SeenScan {
  ScanPoints points;
  SE2 T_map_base;  ///< True pose at the time of the points.
};

/// The first scan with points that begins at `after` or later.
SeenScan scan_after(SimulatorSource& source, Stamp after, const MhAmclConfig& config, bool layers) {
  localization::SensorInputConfig wanted = config.input;
  wanted.layers = layers;
  localization::SensorInput input(wanted);
  SE2 T_map_base;
  while (auto frame = source.next()) {
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame->data)) {
      input.take(odometry->odometry);
      T_map_base = T_map_base_of(odometry->true_pose).value_or(T_map_base);
    }
    if (const auto* imu = std::get_if<ImuFrame>(&frame->data)) input.take(imu->imu);
    const auto* scan = std::get_if<ScanFrame>(&frame->data);
    if (scan == nullptr) continue;
    auto turn = input.take(scan->scan);
    if (scan->scan.stamp < after || !turn || turn->points.empty()) continue;
    return {std::move(turn->points), T_map_base};
  }
  throw std::runtime_error(
      fmt::format("no lidar sees anything from {} s to the end of the run at {} s", seconds(after),
                  seconds(source.duration())));
}

CostMap cost_map(const RosMap& map, const MhAmclConfig& config) {
  localization::OccupancyGrid grid = to_occupancy_grid(map);
  const localization::OccupancyGrid surfaces = hollow(grid, config.surface_depth);
  return {std::move(grid), {surfaces, config.max_distance}};
}

std::vector<ObservedBeam> beams_of(const ScanPoints& points, const std::vector<float>& logs,
                                   const Eigen::Isometry3f& T_map_base) {
  std::vector<ObservedBeam> beams;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f origin(points.origin_x[i], points.origin_y[i], points.origin_z[i]);
    const Eigen::Vector3f end(points.x[i], points.y[i], points.z[i]);
    beams.push_back({T_map_base * origin, T_map_base * end, std::exp(logs[i])});
  }
  return beams;
}

/// On a planar map: base is in space where it truly is, the model projects end points to the plane.
void judge_on_plane(const SeenScan& seen, const Eigen::Isometry3d& T_footprint_base,
                    Observation& observation) {
  const EndpointModel model(observation.model, observation.planar->distances);
  observation.T_map_base = localization::to_se3(seen.T_map_base) * T_footprint_base;
  observation.beams =
      beams_of(seen.points, model.beam_log_likelihoods(seen.points, seen.T_map_base),
               observation.T_map_base.cast<float>());
}

/// Log-likelihoods of beams by what weighs particles on a 3-D map.
std::vector<float> weigh_beams(const ScanPoints& points, const SE2& T_atlas_base,
                               const MhAmclConfig& config, const Volume& volume) {
  if (config.track_by == localization::TrackingError::kAlongBeam) {
    const localization::AlongBeamModel model(config.tracking, volume);
    return model.beam_log_likelihoods(points, T_atlas_base);
  }
  return EndpointModel(config.tracking, volume).beam_log_likelihoods(points, T_atlas_base);
}

/// On a 3-D map: base stands on the ground of the map.
void judge_in_space(const SeenScan& seen, double height, const MhAmclConfig& config,
                    Observation& observation) {
  const Volume& volume = *observation.volume;
  const auto T_atlas_base = volume.atlas().to_atlas(seen.T_map_base, height);
  const auto base = T_atlas_base ? volume.lift(*T_atlas_base) : std::nullopt;
  if (!base) {
    throw std::runtime_error(fmt::format("the robot at ({:.2f}, {:.2f}) is not on drivable ground",
                                         seen.T_map_base.x, seen.T_map_base.y));
  }
  observation.T_map_base = base->T_map_base;
  observation.beams = beams_of(seen.points, weigh_beams(seen.points, *T_atlas_base, config, volume),
                               base->T_map_base.cast<float>());
}

}  // namespace

sim::SceneItem cost_map_item(const CostMap& map, const localization::EndpointConfig& model,
                             const MapWindow& window) {
  sim::SceneItem item;
  item.casts_shadow = false;
  const localization::GridFrame& frame = map.grid.frame;
  const auto flat = [](const Eigen::Vector2d&) { return 0.0; };
  for_cells(frame, window, [&](const Eigen::Vector2i& cell) {
    add_cell(cell_corners(frame, cell, frame.resolution, flat), Eigen::Vector3f::UnitZ(),
             color_of(map, model, frame.index(cell)), item.mesh);
  });
  return item;
}

Observation observe(const Scenario& scenario, const std::filesystem::path& base, double time_s) {
  PreparedSimulation prepared = build_simulation(scenario, base);
  const bool on_3d_map = prepared.config.levels || is_3d(scenario);
  const MhAmcl3dConfig config = localizer_of(scenario, on_3d_map);
  Observation seen;
  seen.model = config.mh_amcl.tracking;
  seen.robot = robot_items(prepared.config.robot, prepared.config.lidars);
  seen.robot_size = 2.0 * prepared.config.robot.footprint_radius;
  seen.T_base_laser = prepared.config.lidars.front().T_base_laser;
  seen.warnings = prepared.warnings;
  if (on_3d_map) {
    seen.volume = volume_of(prepared.config, prepared.survey)(config.voxel);
  } else {
    seen.planar = cost_map(prepared.map, config.mh_amcl);
  }
  const auto source = build_source(scenario, std::move(prepared.config));
  if (time_s == 0.0) source->set_command(sim::Twist2{});
  const Stamp after = localization::from_seconds(std::max(time_s, kSettle));
  if (after > source->duration()) {
    throw std::runtime_error(fmt::format("there is no scan at {} s: the run ends at {} s", time_s,
                                         seconds(source->duration())));
  }
  const SeenScan scan = scan_after(*source, after, config.mh_amcl, seen.volume != nullptr);
  const Eigen::Isometry3d T_footprint_base = source->T_footprint_base();
  if (seen.volume) {
    judge_in_space(scan, T_footprint_base.translation().z(), config.mh_amcl, seen);
  } else {
    judge_on_plane(scan, T_footprint_base, seen);
  }
  seen.people = source->people_items();
  return seen;
}

}  // namespace castaway::testbed
