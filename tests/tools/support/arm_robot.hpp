/// A robot whose arm sticks out.
#pragma once

#include <string>

#include "tools/base/files/file.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {

/// URDF of a waffle with a bar of 2.2 m along it, 0.3 m above its base.
inline std::string waffle_with_arm() {
  std::string urdf = read_file(find_robot("waffle", "."));
  urdf.replace(
      urdf.rfind("</robot>"), 8,
      "<link name=\"arm\"><collision><geometry><box size=\"2.2 0.1 0.1\"/></geometry>"
      "</collision></link><joint name=\"shoulder\" type=\"fixed\"><parent "
      "link=\"base_link\"/><child link=\"arm\"/><origin xyz=\"0 0 0.3\"/></joint></robot>");
  return urdf;
}

}  // namespace castaway::testbed
