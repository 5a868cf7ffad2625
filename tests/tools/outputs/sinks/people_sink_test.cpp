#include "tools/outputs/sinks/people_sink.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(PeopleSink, WritesARowForEveryPersonNowAndThen) {
  const TemporaryFolder folder;
  PeopleSink sink(folder.path(), 2.0);
  for (int t = 0; t < 4; ++t) {
    ScanRecord record = record_at(t, {});
    record.people.people = {{0, {1.0, 2.0, 0.5}, {0.25, -0.5}, 1.25}, {1, {t * 1.0, 0.0, 0.0}}};
    sink.on_scan(record);
  }
  sink.finish({}, {});
  EXPECT_EQ(read_file(folder.path() / "people.csv"),
            "stamp_s,id,x_m,y_m,yaw_rad,vx_mps,vy_mps,gap_m\n"
            "0.000000,0,1.000000,2.000000,0.500000,0.250,-0.500,1.250\n"
            "0.000000,1,0.000000,0.000000,0.000000,0.000,0.000,0.000\n"
            "2.000000,0,1.000000,2.000000,0.500000,0.250,-0.500,1.250\n"
            "2.000000,1,2.000000,0.000000,0.000000,0.000,0.000,0.000\n");
}

}  // namespace
}  // namespace castaway::testbed
