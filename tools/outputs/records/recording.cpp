#include "tools/outputs/records/recording.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/base/bytes/gzip.hpp"
#include "tools/base/bytes/json_number.hpp"
#include "tools/base/bytes/varint.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostSide = 32768;  // Same limit as for pictures of maps.
constexpr int kMostCells = 1 << 29;
constexpr std::string_view kFirstLine = "castaway recording 1\n";

[[noreturn]] void refuse(const std::string& why) {
  throw std::runtime_error("not a recording of this version: " + why + "; run it again");
}

/// Parses the header; `at` becomes the offset behind it.
Json parse_header(std::string_view bytes, std::size_t& at) {
  if (!bytes.starts_with(kFirstLine)) refuse("its first line is different");
  const std::size_t end = bytes.find('\n', kFirstLine.size());
  if (end == std::string_view::npos) refuse("it ends within its header");
  at = end + 1;
  const std::string_view text = bytes.substr(kFirstLine.size(), end - kFirstLine.size());
  if (nests_too_deep(text)) refuse("its header is broken");
  Json header = Json::parse(text, nullptr, false);
  if (header.is_discarded() || !header.contains("sections")) refuse("its header is broken");
  return header;
}

}  // namespace

std::string pack_recording(Json header, const std::vector<RecordingSection>& sections) {
  std::string body;
  header["sections"] = Json::array();
  for (const RecordingSection& section : sections) {
    header["sections"].push_back({{"name", section.name}, {"bytes", section.bytes.size()}});
    body += section.bytes;
  }
  return gzip(std::string(kFirstLine) + json_text(header) + "\n" + body);
}

Recording unpack_recording(std::string_view file) {
  const std::string bytes = gunzip(file);
  std::size_t at = 0;
  Recording recording{parse_header(bytes, at), {}};
  for (const Json& section : recording.header["sections"]) {
    const auto size = integer<std::size_t>(section.at("bytes"));
    if (size > bytes.size() - at) refuse("it ends within section " + json_text(section.at("name")));
    recording.sections[section.at("name").get<std::string>()] = bytes.substr(at, size);
    at += size;
  }
  return recording;
}

std::string pack_cells(const RosMap& map) {
  std::string bytes;
  for (std::size_t begin = 0, end = 0; begin < map.cells.size(); begin = end) {
    while (end < map.cells.size() && map.cells[end] == map.cells[begin]) ++end;
    append_varint(bytes, static_cast<std::uint64_t>(map.cells[begin] + 1));
    append_varint(bytes, end - begin);
  }
  return bytes;
}

Json map_header(const RosMap& map) {
  return {{"name", map.name},
          {"width", map.width},
          {"height", map.height},
          {"resolution_m", map.resolution},
          {"origin", {map.origin_x, map.origin_y, map.origin_yaw}}};
}

static RosMap read_map(const Json& header, std::string_view packed) {
  RosMap map;
  map.name = header.at("name").get<std::string>();
  map.width = integer<int>(header.at("width"));
  map.height = integer<int>(header.at("height"));
  map.resolution = header.at("resolution_m").get<double>();
  map.origin_x = header.at("origin").at(0).get<double>();
  map.origin_y = header.at("origin").at(1).get<double>();
  map.origin_yaw = header.at("origin").at(2).get<double>();
  if (map.width < 1 || map.height < 1 || map.width > kMostSide || map.height > kMostSide ||
      map.width > kMostCells / map.height) {
    refuse("its map has no sensible size");
  }
  const auto cells = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  for (VarintReader reader(packed); !reader.done();) {
    const auto value = static_cast<std::int8_t>(static_cast<int>(reader.next()) - 1);
    const std::uint64_t count = reader.next();
    if (count > cells - map.cells.size()) refuse("its map has too many cells");
    map.cells.insert(map.cells.end(), count, value);
  }
  if (map.cells.size() != cells) refuse("its map lacks cells");
  return map;
}

RosMap map_of(const Recording& recording) {
  return read_map(recording.header.at("map"), recording.sections.at("map"));
}

Json levels_header(const LevelMaps& levels) {
  Json heights = Json::array();
  for (const LevelMap& level : levels) heights.push_back(level.z);
  return {{"map", map_header(levels.front().map)}, {"z_m", std::move(heights)}};
}

LevelMaps levels_of(const Recording& recording) {
  if (!recording.header.contains("levels")) return {};
  const Json& header = recording.header.at("levels");
  LevelMaps levels;
  for (const Json& z : header.at("z_m")) {
    const std::string section = "level/" + std::to_string(levels.size());
    const auto found = recording.sections.find(section);
    if (found == recording.sections.end()) refuse("it lacks the section " + section);
    levels.push_back({z.get<double>(), read_map(header.at("map"), found->second)});
  }
  return levels;
}

}  // namespace castaway::testbed
