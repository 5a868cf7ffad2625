#include "tools/outputs/sinks/points_sink.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

TEST(PlyText, ListsPointsWithIntensityAndLabel) {
  EXPECT_EQ(ply_text({{{1.0F, -2.0F, 0.5F}, 0.25F, 7}}),
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
            "float z\nproperty float intensity\nproperty int label\nend_header\n"
            "1.0000 -2.0000 0.5000 0.25 7\n");
}

TEST(PointsSink, WritesAFileForEachLidarNowAndThen) {
  const TemporaryFolder folder;
  PointsSink sink(folder.path(), 2.0);
  for (int t = 0; t < 4; ++t) {
    ScanRecord record = record_at(t, {});
    record.scan.lidar = t % 2 == 0 ? "front" : "rear/top";
    record.truth.cloud = {{{1.0F, 0.0F, 0.0F}, 0.5F, 1}};
    sink.on_scan(record);
  }
  for (const char* name :
       {"front-0000000", "rear_top-0001000", "front-0002000", "rear_top-0003000"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "points" / (std::string(name) + ".ply")))
        << name;
  }
}

}  // namespace
}  // namespace castaway::testbed
