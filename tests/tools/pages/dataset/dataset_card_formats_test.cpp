#include "tools/pages/dataset/dataset_card_formats.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

std::string described(const std::vector<std::string>& paths) {
  DatasetContents contents;
  for (const std::string& path : paths)
    contents.files.push_back({"sequences/000000/" + path, 0, ""});
  return describe_formats(contents);
}

TEST(DatasetCardFormats, SayHowToLoadWhatIsThere) {
  const std::string text = described({"tables.h5", "bag/a.mcap", "kitti/poses.txt"});
  EXPECT_TRUE(contains(text, "import h5py"));
  EXPECT_TRUE(contains(text, "ros2 bag play sequences/000000/bag"));
  EXPECT_TRUE(contains(text, "`kitti/poses.txt`"));
}

TEST(DatasetCardFormats, SayNothingOfWhatIsNot) {
  const std::string text = described({"tables/scans.csv", "truth.tum"});
  EXPECT_TRUE(contains(text, "import numpy as np, pandas as pd"));
  EXPECT_TRUE(contains(text, "evo_traj tum"));
  EXPECT_EQ(text.find("h5py"), std::string::npos);
  EXPECT_EQ(text.find("bag"), std::string::npos);
}

}  // namespace
}  // namespace castaway::testbed
