// Robots with meshes in all common formats.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/load_robot.hpp"
#include "sim/robot/urdf/part_points.hpp"
#include "tests/sim/robot/urdf_parts_for_tests.hpp"
#include "tests/support/robot_files.hpp"

namespace castaway::sim {
namespace {

using testing::HasSubstr;

// A triangle with corners (0, 0, 0), (1, 0, 0), (0, 2, 0.5) m, in each format.
const char* const kStl =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0.5\n"
    "endloop\nendfacet\nendsolid t\n";
const char* const kObj = "v 0 0 0\nv 1 0 0\nv 0 2 0.5\nf 1 2 3\n";
const char* const kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 2 "
    "0.5\n3 0 1 2\n";
const char* const kDae =
    R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 100 0 0 0 200 50</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
// The buffer: nine floats of four bytes, little-endian, as base64.
const char* const kGltf =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,2,0.5]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAA/"}]})";

class MeshFormats : public RobotFiles {
 protected:
  [[nodiscard]] RobotModel load(const std::string& mesh) const {
    return load_robot(write(
        "r.urdf",
        robot_urdf("<link name=\"base_link\"><inertial><mass value=\"2\"/><inertia ixx=\".02\" "
                   "iyy=\".02\" izz=\".02\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial><visual>"
                   "<geometry><mesh filename=\"" +
                   mesh + "\"/></geometry></visual></link>" + wheel_urdf("l", 0.0, 0.12) +
                   wheel_urdf("r", 0.0, -0.12))));
  }
};

TEST_F(MeshFormats, GiveTheSameTriangle) {
  const std::map<std::string, std::string> files{{"a.stl", kStl}, {"B.STL", kStl},
                                                 {"c.obj", kObj}, {"d.ply", kPly},
                                                 {"e.dae", kDae}, {"f.gltf", kGltf}};
  for (const auto& [name, text] : files) {
    write(name, text);
    const RobotModel robot = load(name);
    Eigen::AlignedBox3d box;
    for (const RobotPart& part : robot.visuals) {
      for (const Eigen::Vector3d& p : part_points(part)) box.extend(p);
    }
    ASSERT_TRUE(std::holds_alternative<MeshShape>(robot.visuals.at(0).shape)) << name;
    EXPECT_TRUE(box.sizes().isApprox(Eigen::Vector3d(1.0, 2.0, 0.5), 1e-5)) << name;
  }
}

TEST_F(MeshFormats, OneDrawnInMillimetresIsScaled) {
  write("mm.obj", "v 0 0 0\nv 100 0 0\nv 0 200 50\nf 1 2 3\n");
  const RobotModel robot = load("mm.obj");
  EXPECT_THAT(robot.warnings, testing::Contains(HasSubstr("taken for millimetres")));
  EXPECT_LT(robot.footprint_radius, 0.5);
}

TEST_F(MeshFormats, BrokenOnesBecomeBoxes) {
  write("torn.dae", "<COLLADA><library_geom");
  write("empty.stl", "");
  write("cut.gltf", R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POS)");
  for (const char* name : {"torn.dae", "empty.stl", "cut.gltf"}) {
    EXPECT_THAT(load(name).warnings, testing::Contains(HasSubstr("a box replaces it"))) << name;
  }
}

TEST_F(MeshFormats, GiganticFilesAreRefused) {
  const std::string path = write("huge.stl", kStl);
  std::filesystem::resize_file(path, (129U << 20U));
  EXPECT_THAT(error_text([&] { (void)load("huge.stl"); }),
              testing::AllOf(HasSubstr("huge.stl"), HasSubstr("129 MiB"), HasSubstr("simplify")));
}

TEST_F(MeshFormats, MeshesOfTooManyTrianglesAreRefused) {
  std::string obj = kObj;
  obj.reserve(8U << 20U);
  for (int i = 0; i < 1000001; ++i) obj += "f 1 2 3\n";
  write("many.obj", obj);
  EXPECT_THAT(error_text([&] { (void)load("many.obj"); }), HasSubstr("1000002 triangles"));
}

}  // namespace
}  // namespace castaway::sim
