/// Points of PLY files (Polygon File Format of Greg Turk), version 1.0.
///
/// Not assimp, which reads robots' meshes: it rounds doubles to floats (0.25 m at the northings of
/// UTM), and does not name the line that is wrong.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace castaway::testbed {

/// The x, y and z of all vertices, also of those that are not finite; faces are ignored. The format
/// is ascii, binary_little_endian or binary_big_endian. `name` is the file's name in errors. Throws
/// std::runtime_error naming it if the data are malformed or truncated.
std::vector<Eigen::Vector3d> decode_ply(std::string_view bytes, const std::string& name);

}  // namespace castaway::testbed
