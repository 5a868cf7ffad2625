/// A small campaign for program tests.
#pragma once

#include "tests/program/dataset_files.hpp"

namespace castaway::test {

inline constexpr const char* kGrid = R"(name: little
scenario:
  world: room.yaml
  duration_s: 16
  physics: kinematic
  start: {random: true}
  drive: {route: random}
  lidar: {beams: 36, rate_hz: 5}
  events:
    - kidnap: {kind: teleport, at_s: 2.1, min_distance_m: 2}
grid:
  lidar.range_max: [3, 8]
  localizers: [[mh_amcl], [amcl]]
draw:
  events.0.kidnap.at_s: {uniform: [1.5, 2.5]}
seeds: 3
)";

/// The folder of the specification s.yaml.
inline fs::path folder_with_grid(const std::string& more = "") {
  return folder_with_spec(std::string(kGrid) + more);
}

inline const std::vector<std::string> kTables{"results.csv", "kidnaps.csv", "results.h5",
                                              "summary.json"};

inline void expect_same_tables(const fs::path& a, const fs::path& b) {
  for (const std::string& name : kTables) {
    EXPECT_EQ(text_of(a / name), text_of(b / name)) << name;
    EXPECT_FALSE(text_of(a / name).empty()) << name;
  }
}

inline int lines_of(const fs::path& file) {
  const std::string text = text_of(file);
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace castaway::test
