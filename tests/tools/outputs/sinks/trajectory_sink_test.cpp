#include "tools/outputs/sinks/trajectory_sink.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/formats/tum.hpp"

namespace castaway::testbed {
namespace {

TEST(TrajectorySink, WritesTheTruthAndEachLocalizerAtTheScansStamps) {
  const TemporaryFolder folder;
  const std::vector<std::string> names{"a", "group/b"};
  TrajectorySink sink(folder.path(), run_of(names));
  ScanRecord record = record_at(1.25, names);
  record.localizers[1].estimate.reset();
  sink.on_scan(record);
  record = record_at(2.5, names);
  record.true_pose.reset();
  record.localizers[0].estimate->T_map_base.yaw = -0.5 * std::numbers::pi;
  sink.on_scan(record);
  sink.finish(Stamp{}, {});
  EXPECT_EQ(read_file(folder.path() / "truth.tum"),
            "1.250000000 0.125000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 "
            "1.000000000\n");
  const std::string a = read_file(folder.path() / "a.tum");
  EXPECT_EQ(std::count(a.begin(), a.end(), '\n'), 2);
  EXPECT_TRUE(a.ends_with(
      "\n2.500000000 0.250000000 0.200000000 0.000000000 0.000000000 0.000000000 -0.707106781 "
      "0.707106781\n"));
  const std::string b = read_file(folder.path() / "group_b.tum");
  EXPECT_EQ(std::count(b.begin(), b.end(), '\n'), 1);
}

TEST(TrajectorySink, LinesHaveEightColumnsOneSpaceApartAndAUnitQuaternion) {
  const TemporaryFolder folder;
  TrajectorySink sink(folder.path(), run_of({"a"}));
  for (int i = 0; i < 20; ++i) {
    ScanRecord record = record_at(0.3 * i, {"a"});
    record.localizers[0].estimate->T_map_base = {-1.0 * i, 0.0, 0.7 * i};
    sink.on_scan(record);
  }
  sink.finish(Stamp{}, {});
  std::istringstream lines(read_file(folder.path() / "a.tum"));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_EQ(line.find("  "), std::string::npos) << line;
    EXPECT_NE(line.back(), ' ') << line;
    std::istringstream cells(line);
    std::vector<double> values;
    for (double value = 0.0; cells >> value;) values.push_back(value);
    ASSERT_EQ(values.size(), 8U) << line;
    EXPECT_EQ(values[4], 0.0);
    EXPECT_EQ(values[5], 0.0);
    EXPECT_NEAR(std::hypot(values[6], values[7]), 1.0, 1e-8);
    EXPECT_NEAR(std::remainder(2.0 * std::atan2(values[6], values[7]) - 0.7 * count,
                               2.0 * std::numbers::pi),
                0.0, 1e-8);
  }
  EXPECT_EQ(count, 20);
}

TEST(TrajectorySink, StampsGrowWhateverTheOrderOfScans) {
  const TemporaryFolder folder;
  TrajectorySink sink(folder.path(), run_of({"a"}));
  for (const double t : {1.0, 2.0, 1.5, 2.0, 3.0}) sink.on_scan(record_at(t, {"a"}));
  sink.finish(Stamp{}, {});
  const std::string text = read_file(folder.path() / "truth.tum");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

TEST(TrajectorySink, LeavesNothingOfARunThatDoesNotEnd) {
  const TemporaryFolder folder;
  { TrajectorySink(folder.path(), run_of({"a"})).on_scan(record_at(1.0, {"a"})); }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace castaway::testbed
