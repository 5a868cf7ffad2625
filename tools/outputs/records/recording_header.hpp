/// What a player knows of a run before its first scan.
#pragma once

#include <cstddef>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "tools/base/formats/ros_map.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Names, steps of quantization, and the map's frame; the list of lidars is empty.
/// `robot_radius_m` [m]: of the outlines of robot and estimates.
nlohmann::ordered_json recording_header(const RunInfo& info, const RosMap& map,
                                        double robot_radius_m);

/// A change of the world, for the list `changes` in the header: {time [s], name, outline: [[x, y],
/// ...], z: [lower, upper]} [m]. If the outline is empty, nothing of that name stands there any
/// more.
nlohmann::ordered_json change_entry(Stamp stamp, const sim::WorldNews& news);

/// [height, roll, pitch] of base. [m], [rad]
Eigen::Vector3d lift_of(const Eigen::Isometry3d& T_footprint_base);

/// Index of the scan's lidar in the header; it is added at its first scan. `stride`: of the beams
/// that are kept.
std::size_t recorded_lidar(const LaserScan& scan, std::size_t stride,
                           nlohmann::ordered_json& header);

}  // namespace castaway::testbed
