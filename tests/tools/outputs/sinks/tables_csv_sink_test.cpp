#include "tools/outputs/sinks/tables_csv_sink.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/table_records.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(TablesCsvSink, WritesARowForEveryScan) {
  const TemporaryFolder folder;
  TablesCsvSink sink(folder.path(), {"mh_amcl"}, table_context());
  play_two_scans(sink);
  EXPECT_EQ(read_file(folder.path() / "tables/scans.csv"),
            "stamp_s,lidar,x_m,y_m,yaw_rad,odom_x_m,odom_y_m,odom_yaw_rad,since_kidnap_s,held,torn,"
            "occluded,ambiguity,lost_mh_amcl,ranges_m,classes,hits\n"
            "1.000000,front,0.100000,0.000000,0.000000,0.100000,0.000000,0.000000,,0,0,0.3333,"
            "0.2500,0,1.5000 0.7500 inf,1 5 0,0 2 -1\n"
            "2.000000,front,0.200000,0.000000,0.000000,0.200000,0.000000,0.000000,0.500000,0,0,"
            "0.3333,0.2500,0,1.5000 0.7500 inf,1 5 0,0 2 -1\n");
}

TEST(TablesCsvSink, OnSeveralFloorsTruePosesHaveHeightRollAndPitch) {
  const TemporaryFolder folder;
  TablesCsvSink sink(folder.path(), {"mh_amcl"}, table_context(), true);
  play_two_scans(sink, on_a_ramp());
  for (const char* name : {"scans.csv", "odometry.csv"}) {
    const CsvTable table = read_csv(folder.path() / "tables" / name);
    const auto& row = table.rows.at(0);
    EXPECT_EQ(row[table.column("z_m")], "3.500000") << name;
    EXPECT_EQ(row[table.column("roll_rad")], "0.250000") << name;
    EXPECT_EQ(row[table.column("pitch_rad")], "-0.125000") << name;
    EXPECT_EQ(row[table.column("odom_yaw_rad")], name[0] == 's' ? "0.000000" : "0.250000") << name;
  }
}

TEST(TablesCsvSink, WritesWhatTheScansReferTo) {
  const TemporaryFolder folder;
  TablesCsvSink sink(folder.path(), {"mh_amcl"}, table_context());
  play_two_scans(sink);
  const auto line = [&](const char* name, std::size_t row) {
    return read_csv(folder.path() / "tables" / name).rows.at(row);
  };
  EXPECT_EQ(line("objects.csv", 0), (std::vector<std::string>{"0", "1", "static", "wall"}));
  EXPECT_EQ(line("people.csv", 1),
            (std::vector<std::string>{"2.000000", "2", "4.000000", "5.000000", "0.500000", "1.000",
                                      "-0.500", "0.250"}));
  EXPECT_EQ(line("odometry.csv", 0),
            (std::vector<std::string>{"1.000000", "0.500000", "0.000000", "0.250000", "0.125000",
                                      "0.000000", "0.000000"}));
  const CsvTable lidars = read_csv(folder.path() / "tables/lidars.csv");
  ASSERT_EQ(lidars.rows.size(), 1U);
  EXPECT_EQ(lidars.rows[0][lidars.column("beams")], "3");
  EXPECT_EQ(lidars.rows[0][lidars.column("angle_increment_rad")], "0.250000000");
  EXPECT_EQ(lidars.rows[0][lidars.column("mount_yaw_rad")], "1.500000");
}

}  // namespace
}  // namespace castaway::testbed
