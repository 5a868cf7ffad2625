/// Points of PCD files (Point Cloud Data of the Point Cloud Library), versions .5 to 0.7.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace castaway::testbed {

/// The fields x, y and z of all points, also of those that are not finite. DATA is ascii, binary or
/// binary_compressed; VIEWPOINT is not applied. `name` is the file's name in errors. Throws
/// std::runtime_error naming it if the data are malformed or truncated.
std::vector<Eigen::Vector3d> decode_pcd(std::string_view bytes, const std::string& name);

}  // namespace castaway::testbed
