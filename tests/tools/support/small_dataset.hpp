/// A data set of three sequences in two worlds, for tests.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/batch/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Content of a sequence.json; `number` starts at 0.
inline nlohmann::ordered_json small_sequence(int number, const std::string& world) {
  using Json = nlohmann::ordered_json;
  Json kidnaps = Json::array();
  if (number > 0) kidnaps.push_back({{"kind", "turn"}, {"at_s", 1.0}, {"distance_m", 5.0}});
  return {{"sequence", "00000" + std::to_string(number)},
          {"seed", 100 + number},
          {"world", world},
          {"robot", "waffle"},
          {"drawn", {{"people.count", std::to_string(2 * number)}, {"robot", "waffle"}}},
          {"duration_s", 60.0},
          {"distance_m", 10.0 * number},
          {"scans", 4},
          {"people", 2 * number},
          {"collisions", 0},
          {"faults", 0},
          {"kidnaps", kidnaps},
          {"difficulty",
           {{"ambiguity", 0.25 * number},
            {"occluded_mean", 0.1},
            {"occluded_max", 0.5},
            {"odometry_error_per_m", number == 0 ? Json() : Json(0.01 * number)},
            {"odometry_yaw_error_rad_per_m", nullptr},
            {"map_ambiguity", 0.5},
            {"map_twins", 0.25},
            {"map_difference", 0.0}}},
          {"statistics",
           {{"ranges", {1, 2 * number}},
            {"occluded", {4, 0}},
            {"odometry_error_m", {{1, 0.1 * number}}},
            {"coverage", {{0, 0, 4}}}}},
          {"files", Json::array({{{"path", "truth.tum"}, {"bytes", 3}, {"sha256", "abc"}}})}};
}

/// Three finished sequences: one in `flat`, two in `office`.
class SmallDataset {
 public:
  SmallDataset() : folder_(temporary_.path() / "set", {"0.1.0", 1, 3, "name: small\n"}) {
    for (int i = 0; i < 3; ++i) {
      const std::string name = "00000" + std::to_string(i);
      write_file(folder_.draft(name) / "truth.tum", "1 2");
      write_file(folder_.draft(name) / "sequence.json",
                 small_sequence(i, i == 0 ? "flat" : "office").dump() + "\n");
      folder_.commit_sequence(name);
    }
  }

  [[nodiscard]] const DatasetFolder& folder() const { return folder_; }

  [[nodiscard]] DatasetContents contents() const {
    DatasetSpec spec;
    spec.name = "small";
    spec.license = "CC0-1.0";
    spec.vary = {{"people.count", FixedDraw{}, ""}, {"robot", FixedDraw{}, ""}};
    RosMap map;
    map.width = 2;
    map.height = 1;
    map.cells = {0, 100};
    return load_contents(folder_, spec, {"000000", "000001", "000002"},
                         {{"flat", map}, {"office", map}});
  }

 private:
  TemporaryFolder temporary_;
  DatasetFolder folder_;
};

}  // namespace castaway::testbed
