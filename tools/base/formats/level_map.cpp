#include "tools/base/formats/level_map.hpp"

namespace castaway::testbed {
namespace {

constexpr double kAbove = 0.5;  // [m] A ramp's last piece belongs to the floor above.

}  // namespace

std::size_t level_at(const LevelMaps& levels, double z) {
  std::size_t found = 0;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (levels[i].z <= z + kAbove) found = i;
  }
  return found;
}

}  // namespace castaway::testbed
