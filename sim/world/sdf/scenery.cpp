#include "sim/world/sdf/scenery.hpp"

#include <algorithm>
#include <cctype>

namespace castaway::sim {
namespace {

/// The last part of a URI in lower case, blanks as underscores.
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

}  // namespace castaway::sim
