#include "tools/pages/dataset/dataset_pages.hpp"

#include <map>

#include <gtest/gtest.h>

#include "tests/tools/support/small_dataset.hpp"

namespace castaway::testbed {
namespace {

TEST(DatasetPages, AreACardAPageOfPlotsAndAPictureOfEachWorld) {
  const SmallDataset dataset;
  std::map<std::string, std::string> plots;
  for (auto& [path, bytes] : dataset_pages(dataset.contents())) plots[path] = bytes;
  EXPECT_EQ(plots.size(), 4U);
  EXPECT_TRUE(contains(plots.at("plots/index.html"), "<h1>Data set small</h1>"));
  EXPECT_EQ(plots.at("plots/coverage-flat.png").substr(1, 3), "PNG");
  EXPECT_TRUE(plots.contains("plots/coverage-office.png"));
}

}  // namespace
}  // namespace castaway::testbed
