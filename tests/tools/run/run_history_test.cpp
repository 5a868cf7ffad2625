#include "tools/run/run_history.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"

namespace castaway::testbed {
namespace {

TEST(RunHistory, KeepsRowsByStampHoweverScansAreDelivered) {
  RunHistory history(run_of({"a"}));
  for (const double t : {0.0, 0.2, 0.1, 0.3}) history.add(record_at(t, {"a"}));
  ASSERT_EQ(history.rows[0].size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_LT(history.rows[0][i - 1].stamp, history.rows[0][i].stamp);
  }
}

}  // namespace
}  // namespace castaway::testbed
