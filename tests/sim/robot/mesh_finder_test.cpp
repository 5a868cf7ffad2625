#include "sim/robot/mesh_finder.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

/// ws/src/my_repo/robots/a.urdf; package my_pkg in a folder of another name; other_pkg beside.
class MeshFinderTest : public testing::Test {
 protected:
  MeshFinderTest() {
    fs::remove_all(root_);
    touch("src/my_repo/package.xml", "<package><name>my_pkg</name></package>");
    touch("src/my_repo/robots/a.urdf", "");
    touch("src/my_repo/robots/near.stl", "");
    touch("src/my_repo/meshes/own.STL", "");
    touch("src/other_pkg/meshes/other.dae", "");
    touch("share/third_pkg/meshes/third.dae", "");
  }
  ~MeshFinderTest() override { fs::remove_all(root_); }

  void touch(const std::string& path, const std::string& text) const {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }
  [[nodiscard]] std::string at(const std::string& path) const { return (root_ / path).string(); }

  fs::path root_ = fs::canonical(fs::temp_directory_path()) /
                   ("castaway_mesh_finder_" +
                    std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  MeshFinder finder_{(root_ / "src/my_repo/robots/a.urdf").string(), {(root_ / "share").string()}};
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
  EXPECT_EQ(finder_.find("file://" + at("src/my_repo/meshes/own.STL")),
            at("src/my_repo/meshes/own.STL"));
}

TEST_F(MeshFinderTest, FindsNothingWhereNothingIs) {
  EXPECT_FALSE(finder_.find("package://my_pkg/meshes/none.stl").has_value());
  EXPECT_FALSE(finder_.find("package://nobody/none.stl").has_value());
  EXPECT_FALSE(finder_.find("file:///none.stl").has_value());
}

}  // namespace
}  // namespace castaway::sim
