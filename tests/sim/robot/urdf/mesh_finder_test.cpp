#include "sim/robot/urdf/mesh_finder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/robot_files.hpp"

namespace castaway::sim {
namespace {

using testing::HasSubstr;

/// src/my_repo/robots/a.urdf; package my_pkg in a folder of another name; other_pkg next to it.
class MeshFinderTest : public RobotFiles {
 protected:
  MeshFinderTest() {
    write("src/my_repo/package.xml", "<package><name>my_pkg</name></package>");
    write("src/my_repo/robots/near.stl", "");
    write("src/my_repo/meshes/own.STL", "");
    write("src/other_pkg/package.xml", "<package><name>other_pkg</name></package>");
    write("src/other_pkg/meshes/other.dae", "");
    write("share/third_pkg/meshes/third.dae", "");
    write("secret.stl", "");
  }
  [[nodiscard]] std::string refusal(const std::string& uri) const {
    return error_text([&] { (void)finder_.find(uri); });
  }

  PackageFinder packages_{at("src/my_repo/robots/a.urdf"), {at("share")}};
  MeshFinder finder_{packages_};
};

TEST_F(MeshFinderTest, FindsThePackageThatHoldsTheFile) {
  EXPECT_EQ(finder_.find("package://my_pkg/meshes/own.STL"), at("src/my_repo/meshes/own.STL"));
  EXPECT_EQ(finder_.find("package://my_repo/meshes/own.STL"), at("src/my_repo/meshes/own.STL"));
}

TEST_F(MeshFinderTest, FindsPackagesBesideAndInSearchPaths) {
  EXPECT_EQ(finder_.find("package://other_pkg/meshes/other.dae"),
            at("src/other_pkg/meshes/other.dae"));
  EXPECT_EQ(finder_.find("model://third_pkg/meshes/third.dae"),
            at("share/third_pkg/meshes/third.dae"));
}

TEST_F(MeshFinderTest, FindsRelativeAndAbsoluteFiles) {
  EXPECT_EQ(finder_.find("near.stl"), at("src/my_repo/robots/near.stl"));
  EXPECT_EQ(finder_.find("../meshes/own.STL"), at("src/my_repo/meshes/own.STL"));
  EXPECT_EQ(finder_.find("meshes/own.STL"), at("src/my_repo/meshes/own.STL"));
  EXPECT_EQ(finder_.find("third_pkg/meshes/third.dae"), at("share/third_pkg/meshes/third.dae"));
  const std::string own = at("src/my_repo/meshes/own.STL");
  EXPECT_EQ(finder_.find("file://" + own), own);
  EXPECT_EQ(finder_.find(own), own);
}

TEST_F(MeshFinderTest, FindsNothingWhereNothingIs) {
  EXPECT_FALSE(finder_.find("package://my_pkg/meshes/none.stl").has_value());
  EXPECT_FALSE(finder_.find("package://nobody/none.stl").has_value());
  EXPECT_FALSE(finder_.find("package://my_pkg").has_value());
  EXPECT_FALSE(finder_.find("none.stl").has_value());
}

TEST_F(MeshFinderTest, RefusesWhatLiesOutside) {
  for (const std::string& uri :
       {std::string("../../../secret.stl"), std::string("package://my_pkg/../../secret.stl"),
        std::string("file:///etc/passwd"), at("secret.stl"),
        "file://" + at("src/my_repo/meshes/../../../secret.stl")}) {
    EXPECT_THAT(refusal(uri), HasSubstr("lies outside")) << uri;
  }
}

TEST_F(MeshFinderTest, RefusesUnknownSchemes) {
  EXPECT_THAT(refusal("http://example.org/a.stl"), HasSubstr("http:// is not known"));
}

}  // namespace
}  // namespace castaway::sim
