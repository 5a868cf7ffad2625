/// What a run leaves behind as YAML.
#pragma once

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads `outputs`; every key has a default.
///
///     outputs:
///       report: true           # report.html
///       player: true           # in it, and the recording.gz that it plays
///       snapshots: {every_s: 0, on_events: true, width: 960, height: 720}   # or false
///       video: {width: 1280, height: 720, fps: 20, speed: 1, view: chase}   # with --video FILE
///       scans: false           # scans.csv, labels.csv
///       tables: hdf5           # or csv, none, [csv, hdf5]: every scan with labels, for learning
///       points: {every_s: 1}   # PLY files of 3-D lidars
///       bag: {compression: zstd, particles: false, snapshots: false}   # bag/; or true, false
///       carmen: false          # log.carmen
///       kitti: false           # kitti/poses.txt, kitti/times.txt
///       map: false             # map/map.yaml, map/map.pgm
///       camera: {rate_hz: 2, width: 640, height: 480, fov_deg: 70, mount_xyz: [0.1, 0, 0.4],
///                mount_rpy: [0, 0, 0], depth: true, instances: true}   # camera/; or true, or
///                false
OutputSpec read_outputs(YamlReader& root);

}  // namespace castaway::testbed
