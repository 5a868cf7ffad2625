/// File format of a run's recording, which the player shows over time.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/base/formats/level_map.hpp"
#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// Quantization steps of a recording.
inline constexpr double kRecordingPose = 1e-4;    ///< [m], [rad] Poses of robot and estimates.
inline constexpr double kRecordingPoint = 0.01;   ///< [m] Particles, beams, people.
inline constexpr double kRecordingAngle = 0.01;   ///< [rad] Populations and people.
inline constexpr double kRecordingShare = 0.001;  ///< Probabilities and qualities.
inline constexpr double kRecordingTime = 1e-4;    ///< [s]

/// A named block of bytes. `recording_sink.hpp` documents names and contents.
struct RecordingSection {
  std::string name;
  std::string bytes;
};

/// A parsed recording.
struct Recording {
  nlohmann::ordered_json header;
  std::map<std::string, std::string> sections;
};

/// Builds the gzipped file: the line "castaway recording 1", a line of JSON (`header`, with the
/// names and lengths of the sections added), and the sections one after another.
std::string pack_recording(nlohmann::ordered_json header,
                           const std::vector<RecordingSection>& sections);

/// Parses the file. Throws std::runtime_error naming what is wrong with it.
Recording unpack_recording(std::string_view file);

/// Run-length encodes the cells of a map as pairs (value + 1, number of cells), row by row from the
/// lower left corner.
std::string pack_cells(const RosMap& map);

/// Header entry of a map.
nlohmann::ordered_json map_header(const RosMap& map);

/// Reads the map of a recording. Throws std::runtime_error if it is incomplete.
RosMap map_of(const Recording& recording);

/// Header entry of floors: {map: as `map_header`, z_m: [their heights]}. The cells of floor K are
/// in the section `level/K`.
nlohmann::ordered_json levels_header(const LevelMaps& levels);

/// Reads the floors of a recording; none if it is of one floor. Throws std::runtime_error if they
/// are incomplete.
LevelMaps levels_of(const Recording& recording);

}  // namespace castaway::testbed
