#include "tools/base/formats/points/point_cloud.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kPcdText =
    "\n# a\n# .PCD\nFIELDS x y z\nPOINTS 3\nDATA ascii\n1 2 3\nnan 0 0\n4 5 6";
constexpr const char* kPlyText =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n1 2 inf\n7 8 9\n";

TEST(PointCloud, IsToldApartByItsFirstBytesAndHoldsFinitePoints) {
  using Points = std::vector<Eigen::Vector3d>;
  const TemporaryFolder folder;
  EXPECT_EQ(read_point_cloud(folder.put("a.ply", kPcdText)),
            (Points{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}));
  EXPECT_EQ(read_point_cloud(folder.put("b.pcd", kPlyText)), (Points{{7.0, 8.0, 9.0}}));
  EXPECT_EQ(
      read_point_cloud(folder.put("c", "VERSION .7\nFIELDS x y z\nWIDTH 1\nDATA ascii\n1 2 3")),
      (Points{{1.0, 2.0, 3.0}}));
  EXPECT_TRUE(read_point_cloud(folder.put("d", "COLUMNS x y z\nPOINTS 0\nDATA ascii\n")).empty());
}

TEST(PointCloud, NamesTheFileThatIsNoCloud) {
  const TemporaryFolder folder;
  for (const char* text : {"", "#", "# VERSION", "LASF", "solid\n"}) {
    EXPECT_TRUE(contains(error_of([&] { read_point_cloud(folder.put("a.pcd", text)); }),
                         "a.pcd: neither PCD nor PLY"))
        << text;
  }
  EXPECT_TRUE(contains(error_of([&] { read_point_cloud(folder.path() / "none.pcd"); }),
                       "none.pcd: cannot be read"));
  EXPECT_TRUE(
      contains(error_of([&] { read_point_cloud(folder.put("a.ply", "ply\nend_header\n")); }),
               "a.ply: its header states no format"));
}

}  // namespace
}  // namespace castaway::testbed
