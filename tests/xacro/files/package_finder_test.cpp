#include "xacro/files/package_finder.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/robot_files.hpp"

namespace castaway {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using PackageFinderTest = RobotFiles;

TEST_F(PackageFinderTest, FindsAncestorsNeighboursAndSearchPaths) {
  write("ws/mine/package.xml", "<package><name>my_pkg</name></package>");
  write("ws/near/package.xml", "<package><name>near</name></package>");
  write("ws/bare/file.txt", "");
  write("far/repo/deep/package.xml", "<package><name>deep_pkg</name></package>");
  write("far/plain/file.txt", "");
  const PackageFinder finder(at("ws/mine/urdf/a.urdf"), {at("far")});
  EXPECT_EQ(finder.find("my_pkg"), at("ws/mine"));
  EXPECT_EQ(finder.find("mine"), at("ws/mine"));
  EXPECT_EQ(finder.find("near"), at("ws/near"));
  EXPECT_EQ(finder.find("deep_pkg"), at("far/repo/deep"));
  EXPECT_EQ(finder.find("plain"), at("far/plain"));
  EXPECT_FALSE(finder.find("bare").has_value());  // A folder beside is not a package because of its
                                                  // name.
  for (const char* name : {"", ".", "..", "../far", "etc", "/"}) {
    EXPECT_FALSE(finder.find(name).has_value()) << name;
  }
}

TEST_F(PackageFinderTest, TheOwnPackageReachesToItsPackageXml) {
  write("ws/mine/package.xml", "<package><name>my_pkg</name></package>");
  const PackageFinder finder(at("ws/mine/robots/x/a.urdf"), {});
  EXPECT_TRUE(finder.may_read(at("ws/mine/meshes/a.stl")));
  EXPECT_FALSE(finder.may_read(at("ws/mine2/a.stl")));
  EXPECT_FALSE(finder.may_read(at("ws/mine/../a.stl")));
  EXPECT_THAT(finder.refusal(at("ws/a.stl")), HasSubstr("--search-path"));
}

TEST_F(PackageFinderTest, WithoutAPackageXmlAUrdfFolderCountsWithTheOneAbove) {
  const PackageFinder in_urdf(at("robot/urdf/a.urdf"), {});
  EXPECT_TRUE(in_urdf.may_read(at("robot/meshes/a.stl")));
  const PackageFinder plain(at("robot/a.urdf"), {});
  EXPECT_TRUE(plain.may_read(at("robot/meshes/a.stl")));
  EXPECT_FALSE(plain.may_read(at("b.stl")));
}

TEST_F(PackageFinderTest, PackagesThatWereFoundMayBeRead) {
  write("ws/near/package.xml", "<package><name>near</name></package>");
  write("ws/mine/package.xml", "<package><name>mine</name></package>");
  const PackageFinder finder(at("ws/mine/a.urdf"), {});
  EXPECT_FALSE(finder.may_read(at("ws/near/a.stl")));
  ASSERT_TRUE(finder.find("near"));
  EXPECT_TRUE(finder.may_read(at("ws/near/a.stl")));
}

TEST(PackagePaths, OfTheEnvironment) {
  ::setenv("CASTAWAY_PACKAGE_PATH", "/a::/b", 1);
  ::setenv("ROS_PACKAGE_PATH", "/c", 1);
  ::setenv("AMENT_PREFIX_PATH", "/opt/d", 1);
  EXPECT_THAT(package_paths_of_environment(), ElementsAre("/a", "/b", "/c", "/opt/d/share"));
  for (const char* name : {"CASTAWAY_PACKAGE_PATH", "ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"}) {
    ::unsetenv(name);
  }
  EXPECT_TRUE(package_paths_of_environment().empty());
}

}  // namespace
}  // namespace castaway
