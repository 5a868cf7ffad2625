#include "tools/outputs/sinks/scans_sink.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(ScansSink, WritesEveryBeamAndWhatItMet) {
  const TemporaryFolder folder;
  ScansSink sink(folder.path(), [](int label) { return "thing " + std::to_string(label); });
  ScanRecord record = record_at(2.0, {});
  record.scan.lidar = "front";
  record.scan.angle_min = -0.5;
  record.scan.angle_increment = 0.25;
  record.scan.ranges = {1.5F, std::numeric_limits<float>::infinity()};
  record.truth.frame = "front_laser";
  record.truth.intensities = {0.125F, 0.0F};
  record.truth.labels = {3, -1};
  sink.on_scan(record);
  sink.finish({}, {});
  EXPECT_EQ(read_file(folder.path() / "scans.csv"),
            "stamp_s,lidar,frame,angle_min_rad,angle_increment_rad,time_increment_s,x_m,y_m,"
            "yaw_rad,ranges_m,intensities,labels\n"
            "2.000000,front,front_laser,-0.500000000,0.250000000,0.000000000,0.200000,0.000000,"
            "0.000000,1.5000 inf,0.125 0,3 -1\n");
  EXPECT_EQ(read_file(folder.path() / "labels.csv"), "label,name\n-1,thing -1\n3,thing 3\n");
}

}  // namespace
}  // namespace castaway::testbed
