#include "tools/outputs/sinks/errors_sink.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

/// Text of errors.csv without its header.
std::string rows_of(const std::vector<ScanRecord>& records) {
  const TemporaryFolder folder;
  ErrorsSink sink(folder.path());
  for (const ScanRecord& record : records) sink.on_scan(record);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "errors.csv"));
  sink.finish(Stamp{}, {});
  const std::string text = read_file(folder.path() / "errors.csv");
  return text.substr(text.find('\n') + 1);
}

TEST(ErrorsSink, WritesARowForEveryLocalizer) {
  ScanRecord record = record_at(3.0, {"a", "b"});
  record.localizers[0].estimate->covariance.diagonal() << 0.01, 0.07, 0.0025;
  record.localizers[0].estimate->lost = true;
  localization::PopulationView population;
  population.particles.resize(3);
  record.localizers[0].diagnostics.populations = {population, population};
  record.localizers[0].diagnostics.populations[1].id = 5;
  record.localizers[0].diagnostics.populations[1].selected = true;
  const std::string poses = "0.300000,0.000000,0.000000,0.300000,0.200000,0.100000,";
  EXPECT_EQ(rows_of({record}),
            "3.000000,a," + poses +
                "0.200000,0.100000,0.750000,0.200000,0.050000,0.500000,1,2,6,5\n3.000000,b," +
                poses + "0.200000,0.100000,0.750000,0.000000,0.000000,0.500000,0,0,0,\n");
}

TEST(ErrorsSink, LeavesEmptyWhatIsNotKnown) {
  ScanRecord record = record_at(3.0, {"a"});
  record.true_pose.reset();
  EXPECT_EQ(rows_of({record}),
            "3.000000,a,,,,0.300000,0.200000,0.100000,,,0.750000,0.000000,0.000000,0.500000,0,0,0,"
            "\n");
  record.localizers[0].estimate.reset();
  EXPECT_EQ(rows_of({record}), "3.000000,a,,,,,,,,,,,,,,0,0,\n");
}

}  // namespace
}  // namespace castaway::testbed
