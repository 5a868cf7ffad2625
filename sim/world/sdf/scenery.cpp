#include "sim/world/sdf/scenery.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace castaway::sim {
namespace {

constexpr std::array<std::string_view, 23> kUnneeded{
    "actor",   "atmosphere", "audio_sink",    "audio_source", "battery",
    "gripper", "gui",        "inertial",      "light",        "particle_emitter",
    "pbr",     "physics",    "plugin",        "population",   "projector",
    "road",    "scene",      "script",        "sensor",       "spherical_coordinates",
    "state",   "surface",    "velocity_decay"};

/// The last part of a URI in lower case, with blanks as underscores.
std::string plain_name(const std::string& uri) {
  std::string name = uri.substr(uri.find_last_of('/') + 1);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  });
  return name;
}

}  // namespace

bool is_ground_plane(const std::string& uri) { return plain_name(uri) == "ground_plane"; }

bool is_scenery(const std::string& uri) { return plain_name(uri) == "sun" || is_ground_plane(uri); }

bool is_unneeded(const std::string& element) {
  return std::find(kUnneeded.begin(), kUnneeded.end(), element) != kUnneeded.end();
}

}  // namespace castaway::sim
