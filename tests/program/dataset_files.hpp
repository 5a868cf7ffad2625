/// Small data sets and their files.
#pragma once

#include <fstream>
#include <map>
#include <string>

#include "tests/program/program.hpp"

namespace castaway::test {

inline const char* const kDatasetSpec = R"(name: little
license: CC0-1.0
scenario:
  world: room.yaml
  duration_s: 4
  physics: kinematic
  start: {random: true}
  drive: {route: random}
  lidar: {beams: 36, rate_hz: 5}
  events:
    - kidnap: {kind: teleport, at_s: 2.1, min_distance_m: 2}
vary:
  people.count: {integer: [0, 2]}
  drive.max_speed: {uniform: [0.2, 0.6]}
outputs: {bag: true, tables: [csv, hdf5], carmen: true, kitti: true, map: true}
)";

/// A folder with a specification and a room of 6 m x 5 m with a pillar.
inline fs::path folder_with_spec(const std::string& spec = kDatasetSpec) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "s.yaml") << spec;
  std::ofstream(folder / "room.yaml")
      << "image: room.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
         "free_thresh: 0.196\n";
  std::ofstream image(folder / "room.pgm");
  image << "P2\n60 50\n255\n";
  for (int row = 0; row < 50; ++row) {
    for (int column = 0; column < 60; ++column) {
      const bool edge = row < 2 || row > 47 || column < 2 || column > 57;
      const bool pillar = row > 15 && row < 22 && column > 12 && column < 20;
      image << (edge || pillar ? 0 : 254) << '\n';
    }
  }
  return folder;
}

/// Content of every file, by path.
inline std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[entry.path().lexically_relative(folder).string()] = text_of(entry.path());
  }
  return files;
}

inline void expect_equal(const fs::path& a, const fs::path& b) {
  const auto left = files_of(a);
  const auto right = files_of(b);
  for (const auto& [path, bytes] : left) {
    ASSERT_TRUE(right.contains(path)) << path << " is missing in " << b;
    EXPECT_EQ(bytes == right.at(path), true) << path;
  }
  EXPECT_EQ(left.size(), right.size());
}

}  // namespace castaway::test
