#include "tools/batch/dataset/dataset_finish.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/small_dataset.hpp"
#include "tools/base/formats/csv.hpp"
#include "tools/pages/dataset/dataset_pages.hpp"

namespace castaway::testbed {
namespace {

TEST(DatasetFinish, LeavesAllThatStandsBesideTheSequences) {
  const SmallDataset dataset;
  const std::filesystem::path& path = dataset.folder().path();
  finish_dataset(dataset.folder(), dataset.contents(), dataset_pages);
  EXPECT_TRUE(dataset.folder().is_finished());
  EXPECT_FALSE(std::filesystem::exists(path / ".work"));
  EXPECT_EQ(read_file(path / "splits/train.txt"), "000001\n000002\n");
  EXPECT_EQ(read_file(path / "splits/val.txt"), "");
  EXPECT_EQ(read_file(path / "splits/test.txt"), "000000\n");
  EXPECT_EQ(read_csv(path / "sequences.csv").rows.size(), 3U);
  EXPECT_TRUE(std::filesystem::exists(path / "maps/office.pgm"));
  EXPECT_TRUE(contains(read_file(path / "maps/office.yaml"), "office.pgm"));
  EXPECT_TRUE(contains(read_file(path / "README.md"), "# small"));
  // The checksums of the sequences' files are copied from their lists, which are made up here.
  EXPECT_EQ(verify_dataset(path).size(), 3U);
  EXPECT_TRUE(contains(verify_dataset(path)[0], "sequences/000000/truth.tum: changed"));
}

TEST(DatasetFinish, TellsWhatItAmountsTo) {
  const SmallDataset dataset;
  DatasetInvocation invocation;
  invocation.wall_s = 10.0;
  invocation.made = 3;
  invocation.workers = 2;
  invocation.cpu_s = 18.0;
  invocation.largest_mb = 64.0;
  const std::string words = describe_dataset(dataset.folder(), dataset.contents(), invocation);
  EXPECT_TRUE(contains(words, "small: 3 sequences, 3.0 min, 30 m, 12 scans"));
  EXPECT_TRUE(contains(words,
                       "3 made now in 10.0 s, 2 at a time: workers busy 90 %, the largest "
                       "took 64 MB"));
  EXPECT_TRUE(contains(words, "Splits: 2 worlds for 3 splits"));
  const auto json =
      nlohmann::ordered_json::parse(dataset_json(dataset.folder(), dataset.contents(), invocation));
  EXPECT_EQ(json.at("scans"), 12.0);
  EXPECT_EQ(json.at("timing").at("made"), 3);
}

}  // namespace
}  // namespace castaway::testbed
