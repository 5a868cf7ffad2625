#include "tools/batch/dataset/sequence_rows.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/tools/support/small_dataset.hpp"

namespace castaway::testbed {
namespace {

TEST(SequenceRows, AreOneForEverySequence) {
  const SmallDataset dataset;
  const auto rows = sequence_rows(dataset.contents());
  ASSERT_EQ(rows.size(), 4U);
  const auto cell = [&](std::size_t row, const std::string& name) {
    const auto found = std::find(rows[0].begin(), rows[0].end(), name);
    EXPECT_NE(found, rows[0].end()) << name;
    return rows[row].at(static_cast<std::size_t>(found - rows[0].begin()));
  };
  EXPECT_EQ(cell(1, "sequence"), "000000");
  EXPECT_EQ(cell(1, "odometry_error_per_m"), "");
  EXPECT_EQ(cell(1, "split"), "test");
  EXPECT_EQ(cell(3, "seed"), "102");
  EXPECT_EQ(cell(3, "world"), "office");
  EXPECT_EQ(cell(3, "odometry_error_per_m"), "0.02");
  EXPECT_EQ(cell(3, "kidnaps"), "1");
  EXPECT_EQ(cell(3, "split"), "train");
  EXPECT_EQ(cell(3, "vary.people.count"), "4");
}

}  // namespace
}  // namespace castaway::testbed
