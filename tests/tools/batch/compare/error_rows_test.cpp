#include "tools/batch/compare/error_rows.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/outputs/sinks/errors_sink.hpp"

namespace castaway::testbed {
namespace {

TEST(ErrorRows, ReadBackWhatARunLeft) {
  const TemporaryFolder folder;
  {
    ErrorsSink sink(folder.path());
    for (const double t : {1.0, 1.5}) {
      ScanRecord record = record_at(t, {"a", "silent"});
      record.localizers[0].estimate->covariance.diagonal() << 0.02, 0.06, 0.1;
      record.localizers[1].estimate.reset();
      sink.on_scan(record);
    }
    sink.finish(localization::from_seconds(2.0), {});
  }
  const auto rows = read_error_rows(folder.path());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].localizer, "a");
  ASSERT_EQ(rows[0].rows.size(), 2U);
  const ErrorRow& row = rows[0].rows[1];
  EXPECT_EQ(row.stamp_s, 1.5);
  EXPECT_EQ(row.error_m, 0.2);
  EXPECT_EQ(row.quality, 0.75);
  EXPECT_EQ(row.sigma_m, 0.2);
  EXPECT_EQ(row.probability, 0.5);
  EXPECT_FALSE(rows[1].rows[0].error_m);
}

}  // namespace
}  // namespace castaway::testbed
