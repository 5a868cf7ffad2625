/// A run of two scans for tests of tables.
#pragma once

#include <limits>
#include <memory>

#include "tests/tools/support/records.hpp"
#include "tools/outputs/records/scan_row.hpp"

namespace castaway::testbed {

inline std::shared_ptr<const LabelContext> table_context() {
  auto made = std::make_shared<LabelContext>();
  made->legend.entries[0] = {BeamClass::kStatic, "wall"};
  made->legend.first_person = 100;
  made->ambiguity = {{{0.0, 0.0}}, {0.25}};
  return made;
}

/// Plays a kidnap at 1.5 s, an odometry reading at 1 s, and scans at 1 s and 2 s with three beams:
/// on the wall, on person 2, a miss. `T_footprint_base`: of base at all times; nothing: on one
/// floor.
inline void play_two_scans(RunSink& sink,
                           const std::optional<Eigen::Isometry3d>& T_footprint_base = {}) {
  OdometryFrame odometry;
  odometry.odometry = {localization::from_seconds(1.0), {0.5, 0.0, 0.25}};
  odometry.true_pose = SE2{0.125, 0.0, 0.0};
  odometry.true_pose->T_footprint_base = T_footprint_base;
  sink.on_odometry(odometry);
  for (const double t : {1.0, 2.0}) {
    if (t > 1.0) sink.on_event(kidnap_to(1.5));
    ScanRecord record = record_at(t, {"mh_amcl"});
    record.true_pose->T_footprint_base = T_footprint_base;
    record.scan.lidar = "front";
    record.scan.angle_min = -0.5;
    record.scan.angle_increment = 0.25;
    record.scan.range_max = 12.0;
    record.scan.T_base_laser.rotate(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitZ()));
    record.scan.ranges = {1.5F, 0.75F, std::numeric_limits<float>::infinity()};
    record.truth.frame = "front_laser";
    record.truth.labels = {0, 102, -1};
    PersonTruth person;
    person.id = 2;
    person.T_map_person = {4.0, 5.0, 0.5};
    person.velocity = {1.0, -0.5};
    person.gap_m = 0.25;
    record.people.people = {person};
    sink.on_scan(record);
  }
  sink.finish(localization::from_seconds(2.1), {});
}

/// On a ramp at 3.5 m: roll 0.25, pitch -0.125.
inline Eigen::Isometry3d on_a_ramp() {
  return Eigen::Translation3d(0.0, 0.0, 3.5) * Eigen::AngleAxisd(-0.125, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(0.25, Eigen::Vector3d::UnitX());
}

}  // namespace castaway::testbed
