/// Header of PLY files (Polygon File Format of Greg Turk), version 1.0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/base/formats/points/cloud_input.hpp"
#include "tools/base/formats/points/scalar.hpp"

namespace castaway::testbed {

/// A number of an element, or a list of numbers.
struct PlyProperty {
  std::string name;
  ScalarType type{};
  std::optional<ScalarType> list_count{};  ///< Type of a list's length; nullopt: one number.
};

/// A kind of record, e.g. vertex or face.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties{};
};

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

/// The element vertex and those before it, in the order of the data.
struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> skipped;  ///< Before the vertices.
  PlyElement vertex;                ///< Its x, y and z occur once and are no lists.
};

/// The axis that a property holds: 0, 1, 2 for x, y, z; -1 for others.
int axis_of(const PlyProperty& property);

/// Takes the header, up to the line end_header. Throws std::runtime_error naming file and line.
PlyHeader read_ply_header(CloudInput& input);

}  // namespace castaway::testbed
