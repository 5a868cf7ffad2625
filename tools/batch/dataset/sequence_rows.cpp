#include "tools/batch/dataset/sequence_rows.hpp"

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Columns of sequences.csv, with JSON pointers into sequence.json.
const std::vector<std::pair<const char*, const char*>> kColumns{
    {"sequence", "/sequence"},
    {"world", "/world"},
    {"robot", "/robot"},
    {"seed", "/seed"},
    {"duration_s", "/duration_s"},
    {"distance_m", "/distance_m"},
    {"scans", "/scans"},
    {"people", "/people"},
    {"collisions", "/collisions"},
    {"faults", "/faults"},
    {"map_ambiguity", "/difficulty/map_ambiguity"},
    {"map_twins", "/difficulty/map_twins"},
    {"map_difference", "/difficulty/map_difference"},
    {"ambiguity", "/difficulty/ambiguity"},
    {"occluded_mean", "/difficulty/occluded_mean"},
    {"occluded_max", "/difficulty/occluded_max"},
    {"odometry_error_per_m", "/difficulty/odometry_error_per_m"},
    {"odometry_yaw_error_rad_per_m", "/difficulty/odometry_yaw_error_rad_per_m"}};

std::string cell_of(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  return json_text(value);
}

}  // namespace

std::vector<std::vector<std::string>> sequence_rows(const DatasetContents& contents) {
  std::vector<std::string> header;
  for (const auto& [name, pointer] : kColumns) header.emplace_back(name);
  header.insert(header.end(), {"kidnaps", "split", "bytes"});
  for (const VariedKey& key : contents.spec.vary) header.push_back("vary." + key.path);
  std::vector<std::vector<std::string>> rows{header};
  for (std::size_t i = 0; i < contents.sequences.size(); ++i) {
    const Json& sequence = contents.sequences[i];
    std::vector<std::string> row;
    for (const auto& [name, pointer] : kColumns) {
      row.push_back(cell_of(sequence.at(Json::json_pointer(pointer))));
    }
    row.push_back(std::to_string(sequence.at("kidnaps").size()));
    row.emplace_back(kSplitNames[static_cast<std::size_t>(contents.splits.part[i])]);
    row.push_back(std::to_string(contents.bytes[i]));
    for (const VariedKey& key : contents.spec.vary) {
      row.push_back(cell_of(sequence.at("drawn").at(key.path)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace castaway::testbed
