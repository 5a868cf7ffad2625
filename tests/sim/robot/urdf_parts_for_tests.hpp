/// Pieces of URDF text for tests.
#pragma once

#include <string>

#include <fmt/format.h>

namespace castaway::sim {

/// A chassis box of 0.3 x 0.2 x 0.1 m, 2 kg, 0.1 m above the axle.
inline std::string chassis_urdf() {
  return R"(<link name="base_link">
  <inertial><mass value="2"/><inertia ixx=".01" iyy=".02" izz=".02" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><origin xyz="0 0 0.1"/><geometry><box size="0.3 0.2 0.1"/></geometry></collision></link>)";
}

/// A wheel `<name>` on a continuous joint `<name>_joint` of base_link (or another parent).
inline std::string wheel_urdf(const std::string& name, double x, double y, double radius = 0.05,
                              const std::string& parent = "base_link") {
  return fmt::format(R"(<link name="{0}"><inertial><mass value="0.1"/>
    <inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin rpy="1.5708 0 0"/><geometry><cylinder radius="{3}" length="0.02"/></geometry>
    </collision></link>
  <joint name="{0}_joint" type="continuous"><parent link="{4}"/><child link="{0}"/>
    <origin xyz="{1} {2} 0"/><axis xyz="0 1 0"/></joint>)",
                     name, x, y, radius, parent);
}

/// A robot made of these parts.
inline std::string robot_urdf(const std::string& inside) {
  return "<robot name=\"test\">" + inside + "</robot>";
}

}  // namespace castaway::sim
