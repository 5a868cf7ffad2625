/// The file of a run's recording: what a player shows of it along time.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/formats/ros_map.hpp"

namespace castaway::testbed {

/// Length of a step in which a recording counts.
inline constexpr double kRecordingPose = 1e-4;    ///< [m], [rad] Poses of robot and estimates.
inline constexpr double kRecordingPoint = 0.01;   ///< [m] Particles, beams, people.
inline constexpr double kRecordingAngle = 0.01;   ///< [rad] Of populations and people.
inline constexpr double kRecordingShare = 0.001;  ///< Of 1: probabilities, qualities.
inline constexpr double kRecordingTime = 1e-4;    ///< [s]

/// Named bytes. The names and what is in them: `recording_sink.hpp`.
struct RecordingSection {
  std::string name;
  std::string bytes;
};

/// A recording, taken apart.
struct Recording {
  nlohmann::ordered_json header;
  std::map<std::string, std::string> sections;
};

/// The file's bytes, gzipped: the line "castaway recording 1", a line of JSON (`header`, with the
/// names and lengths of the sections added), the sections one after another.
std::string pack_recording(nlohmann::ordered_json header,
                           const std::vector<RecordingSection>& sections);

/// Takes the file's bytes apart. Throws std::runtime_error saying what is wrong with them.
Recording unpack_recording(std::string_view file);

/// Cells of a map as pairs: value + 1, how many cells have it; from the lower left corner in rows.
std::string pack_cells(const RosMap& map);

/// What the header says of a map.
nlohmann::ordered_json map_header(const RosMap& map);

/// The map of a recording. Throws std::runtime_error if it is not whole.
RosMap map_of(const Recording& recording);

}  // namespace castaway::testbed
