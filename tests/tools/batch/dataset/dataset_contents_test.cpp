#include "tools/batch/dataset/dataset_contents.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/small_dataset.hpp"
#include "tools/base/bytes/sha256.hpp"

namespace castaway::testbed {
namespace {

TEST(DatasetContents, AreWhatTheSequencesSay) {
  const SmallDataset dataset;
  const DatasetContents contents = dataset.contents();
  EXPECT_EQ(contents.sum("/scans"), 12.0);
  EXPECT_EQ(contents.sum("/distance_m"), 30.0);
  EXPECT_EQ(contents.figures("/difficulty/odometry_error_per_m"),
            (std::vector<double>{0.01, 0.02}));
  EXPECT_EQ(contents.counts("/statistics/ranges"), (std::vector<double>{3.0, 6.0}));
  EXPECT_EQ(contents.splits.part, (std::vector<int>{2, 0, 0}));
}

TEST(DatasetContents, ListEveryFileOfEverySequence) {
  const SmallDataset dataset;
  const DatasetContents contents = dataset.contents();
  ASSERT_EQ(contents.files.size(), 6U);
  EXPECT_EQ(contents.files[0].path, "sequences/000000/truth.tum");
  EXPECT_EQ(contents.files[0].sha256, "abc");
  const std::string text = read_file(dataset.folder().sequence("000001") / "sequence.json");
  EXPECT_EQ(contents.files[3].path, "sequences/000001/sequence.json");
  EXPECT_EQ(contents.files[3].sha256, sha256(text));
  EXPECT_EQ(contents.bytes[1], text.size() + 3);
  EXPECT_EQ(contents.all_bytes(), contents.bytes[0] + contents.bytes[1] + contents.bytes[2]);
}

TEST(DatasetContents, OfADamagedSequenceAreAnError) {
  const SmallDataset dataset;
  write_file(dataset.folder().sequence("000001") / "sequence.json", "{");
  const std::string error = error_of([&] { (void)dataset.contents(); });
  EXPECT_TRUE(contains(error, "000001/sequence.json: is damaged"));
  EXPECT_TRUE(contains(error, "remove the folder and make it again"));
}

TEST(Quantile, IsOfValuesInAnyOrder) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.0), 1.0);
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 1.0), 3.0);
}

}  // namespace
}  // namespace castaway::testbed
