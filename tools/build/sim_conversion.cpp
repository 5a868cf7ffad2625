#include "tools/build/sim_conversion.hpp"

#include <algorithm>
#include <utility>

#include "tools/build/scan_truth.hpp"

namespace castaway::testbed {
namespace {

sim::Cell to_cell(std::int8_t p) {
  if (p >= 65) return sim::Cell::kOccupied;
  return p >= 0 && p < 20 ? sim::Cell::kFree : sim::Cell::kUnknown;
}

std::int8_t to_percent(sim::Cell cell) {
  if (cell == sim::Cell::kOccupied) return 100;
  return cell == sim::Cell::kFree ? std::int8_t{0} : std::int8_t{-1};
}

PeopleTruth people_of(const sim::LidarReading& reading) {
  PeopleTruth truth;
  for (const sim::PersonReading& person : reading.people) {
    truth.people.push_back(
        {person.person, to_se2(person.T_map_person), person.velocity, person.gap});
  }
  const auto hits =
      std::count_if(reading.hit_object.begin(), reading.hit_object.end(), sim::is_person);
  const auto beams = static_cast<double>(std::max<std::size_t>(reading.hit_object.size(), 1));
  truth.beams_on_people = static_cast<double>(hits) / beams;
  return truth;
}

/// A change of the world is not about the robot.
bool has_pose(const sim::Happening& what) { return !std::holds_alternative<sim::WorldNews>(what); }

RunEvent event_of(const sim::HappeningRecord& record) {
  RunEvent event{record.stamp,
                 std::visit([](const auto& what) -> EventData { return what; }, record.what)};
  if (has_pose(record.what)) event.T_map_from = event.T_map_to = to_se2(record.T_map_base);
  return event;
}

RunEvent event_of(const sim::KidnapRecord& record, bool heights) {
  KidnapEvent kidnap{record.kind};
  if (heights) kidnap.heights = {{record.z_from, record.z_to}};
  return {record.stamp, kidnap, to_se2(record.T_map_from), to_se2(record.T_map_to), record.since};
}

}  // namespace

SE2 to_se2(const sim::Pose2& pose) { return {pose.x, pose.y, pose.yaw}; }

sim::Pose2 to_pose2(const SE2& pose) { return {pose.x, pose.y, pose.yaw}; }

RosMap to_ros_map(const sim::Grid& grid, const std::string& name) {
  RosMap map{name,
             grid.width,
             grid.height,
             grid.resolution,
             grid.origin.x(),
             grid.origin.y(),
             grid.origin_yaw,
             {}};
  map.cells.resize(grid.cells.size());
  std::transform(grid.cells.begin(), grid.cells.end(), map.cells.begin(), to_percent);
  return map;
}

sim::Grid to_sim_grid(const RosMap& map) {
  sim::Grid grid{map.width,      map.height, map.resolution, {map.origin_x, map.origin_y},
                 map.origin_yaw, {}};
  grid.cells.resize(map.cells.size());
  std::transform(map.cells.begin(), map.cells.end(), grid.cells.begin(), to_cell);
  return grid;
}

Frame SimFrameConverter::frame(const sim::SimFrame& frame) const {
  if (const auto* kidnap = std::get_if<sim::KidnapRecord>(&frame.data)) {
    return {frame.stamp, event_of(*kidnap, heights_)};
  }
  if (const auto* odometry = std::get_if<sim::OdometryReading>(&frame.data)) {
    OdometryFrame reading{{odometry->stamp, to_se2(odometry->T_odom_base)},
                          to_se2(odometry->T_map_base_true)};
    if (heights_) reading.true_pose->T_footprint_base = odometry->T_footprint_base_true;
    return {frame.stamp, std::move(reading)};
  }
  if (const auto* happening = std::get_if<sim::HappeningRecord>(&frame.data)) {
    return {frame.stamp, event_of(*happening)};
  }
  if (const auto* imu = std::get_if<sim::ImuReading>(&frame.data)) {
    return {frame.stamp, ImuFrame{{imu->stamp, imu->angular_velocity, imu->linear_acceleration}}};
  }
  return {frame.stamp, scan(std::get<sim::LidarReading>(frame.data))};
}

ScanFrame SimFrameConverter::scan(const sim::LidarReading& reading) const {
  const sim::LidarConfig& lidar = lidars_[reading.lidar];
  ScanFrame frame{laser_scan(reading, lidar), to_se2(reading.T_map_base_true), people_of(reading),
                  scan_truth(reading, lidar, clouds_)};
  if (heights_) frame.true_pose->T_footprint_base = reading.T_footprint_base_true;
  return frame;
}

}  // namespace castaway::testbed
