/// Header of PCD files (Point Cloud Data of the Point Cloud Library), versions .5 to 0.7.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/base/formats/points/cloud_input.hpp"
#include "tools/base/formats/points/scalar.hpp"

namespace castaway::testbed {

/// What one point holds under one name.
struct PcdField {
  std::string name;
  ScalarType type{};
  std::uint64_t count = 1;  ///< Numbers per point.
};

enum class PcdData { kAscii, kBinary, kCompressed };

/// A header whose fields hold x, y and z once, as one number each.
struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  PcdData data = PcdData::kAscii;
};

/// Takes the header, up to the line DATA. Throws std::runtime_error naming file and line.
PcdHeader read_pcd_header(CloudInput& input);

}  // namespace castaway::testbed
