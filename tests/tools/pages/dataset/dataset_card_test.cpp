#include "tools/pages/dataset/dataset_card.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/small_dataset.hpp"

namespace castaway::testbed {
namespace {

TEST(DatasetCard, SaysWhatTheDataSetHolds) {
  const SmallDataset dataset;
  const std::string card = dataset_card(dataset.contents());
  EXPECT_TRUE(contains(card, "# small\n"));
  EXPECT_TRUE(contains(card,
                       "3 sequences of a simulated robot with a lidar, 3.0 minutes, 30 m, 12 "
                       "scans"));
  EXPECT_TRUE(contains(card, "Licence: CC0-1.0."));
  EXPECT_TRUE(contains(card, "castaway dataset dataset.yaml -n 3 --out DIR"));
  EXPECT_TRUE(contains(card, "| flat | 1 | 1.0 | 0 | 0 | test |"));
  EXPECT_TRUE(contains(card, "| office | 2 | 2.0 | 30 | 2 | train |"));
  EXPECT_TRUE(contains(card, "2 worlds for 3 splits: val is empty"));
  EXPECT_TRUE(contains(card, "| odometry: error per metre [m] | 0.01 | 0.015 | 0.02 |"));
  EXPECT_TRUE(contains(card, "| odometry: yaw error per metre [rad] | | | |"));
  EXPECT_TRUE(contains(card, "| people.count | 0 to 4 |"));
  EXPECT_TRUE(contains(card, "| robot | `waffle` 3 times |"));
  EXPECT_TRUE(contains(card, "[plots/index.html](plots/index.html) plots them."));
  EXPECT_TRUE(contains(card, "(plots/coverage-office.png)"));
}

TEST(DatasetCard, SaysThatNoLicenceIsStated) {
  const SmallDataset dataset;
  DatasetContents contents = dataset.contents();
  contents.spec.license.clear();
  EXPECT_TRUE(contains(dataset_card(contents), "Licence: none stated."));
}

}  // namespace
}  // namespace castaway::testbed
