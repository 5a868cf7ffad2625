#include "tools/batch/campaign/campaign_tables.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/h5dump.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/batch/campaign/campaign_hdf5.hpp"

namespace castaway::testbed {
namespace {

/// Two combinations with two seeds: cell 1 is void, cell 3 failed.
class CampaignTablesTest : public testing::Test {
 protected:
  CampaignTablesTest() {
    const RowsFile file(folder_.path() / "rows.jsonl");
    for (int i = 0; i < spec_.cells(); ++i) {
      CellRow row;
      row.index = i;
      row.cell = "abc";
      row.seed = static_cast<std::uint64_t>(1 + i % 2);
      row.values = {{"lidar.range_max", i < 2 ? "4" : "8"}};
      row.state = i == 1 ? CellOutcome::kVoid : i == 3 ? CellOutcome::kFailed : CellOutcome::kDone;
      row.reason = i == 3 ? "no, it \"broke\"" : "";
      row.metrics["distance_m"] = 10.0 * i;
      if (i == 0) row.metrics["mh_amcl.recovery.success"] = std::nullopt;
      row.kidnaps = {{"mh_amcl", "teleport", 5.0, SE2{1.0, 2.0, 0.5}, true, i == 0, {}},
                     {"mh_amcl", "carry", 9.0, {}, false, false, {}}};
      if (i == 0) row.kidnaps[0].time_s = 1.5;
      row.cpu_s = 0.25;
      file.add(row_text(row));
    }
  }
  CellRows rows() { return {folder_.path(), spec_.cells()}; }

  TemporaryFolder folder_;
  CampaignSpec spec_ =
      load_campaign_spec(folder_.put("s.yaml",
                                     "name: tables\nscenario: {world: lab}\n"
                                     "grid: {lidar.range_max: [4, 8]}\nseeds: 2\n"),
                         FilePrograms::kRefused);
};

TEST_F(CampaignTablesTest, ResultsHaveARowForEachCell) {
  CellRows index = rows();
  write_results(spec_, index, folder_.path() / "r.csv");
  EXPECT_EQ(read_file(folder_.path() / "r.csv"),
            "cell,name,seed,lidar.range_max,state,reason,distance_m,mh_amcl.recovery.success\n"
            "0,abc,1,4,done,,0.000000000,\n"
            "1,abc,2,4,void,,10.000000000,\n"
            "2,abc,1,8,done,,20.000000000,\n"
            "3,abc,2,8,failed,\"no, it \"\"broke\"\"\",30.000000000,\n");
}

TEST_F(CampaignTablesTest, KidnapsHaveARowForEachKidnap) {
  CellRows index = rows();
  write_kidnaps(spec_, index, folder_.path() / "k.csv");
  const std::string text = read_file(folder_.path() / "k.csv");
  EXPECT_TRUE(contains(text,
                       "\n0,abc,1,4,mh_amcl,teleport,5.000000,1.000000,2.000000,0.500000,"
                       "1,1,1.500000\n"))
      << text;
  EXPECT_TRUE(contains(text, "\n3,abc,2,8,mh_amcl,carry,9.000000,,,,0,0,\n")) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 9);
}

TEST_F(CampaignTablesTest, TheSummaryPoolsWhatCounts) {
  CellRows index = rows();
  const auto summary = campaign_summary(spec_, index);
  EXPECT_EQ(summary.at("cells"), 4);
  const auto& first = summary.at("combinations").at(0);
  EXPECT_EQ(first.at("done"), 1);
  EXPECT_EQ(first.at("void"), 1);
  EXPECT_EQ(first.at("values").at("lidar.range_max"), "4");
  const auto& recovery = first.at("localizers").at("mh_amcl").at("recovery");
  EXPECT_EQ(recovery.at("events"), 1);  // The void cell and the carry are not scored.
  EXPECT_EQ(recovery.at("recovered"), 1);
  const auto& second = summary.at("combinations").at(1);
  EXPECT_EQ(second.at("failed"), 1);
  EXPECT_EQ(second.at("figures").at("distance_m").at("mean"), 20.0);
  const std::string text = campaign_text(summary);
  EXPECT_TRUE(contains(text, "lidar.range_max = 4\n  mh_amcl: 1 of 1 recovered")) << text;
  EXPECT_TRUE(contains(text, "not scored: 0 void, 1 failed")) << text;
}

TEST_F(CampaignTablesTest, Hdf5HasTheSameRows) {
  if (!h5dump_works()) GTEST_SKIP() << "h5dump is not installed (hdf5-tools)";
  CellRows index = rows();
  const auto file = folder_.path() / "r.h5";
  write_hdf5(spec_, index, file);
  const auto shows = [&](const std::string& path, const std::string& text) {
    return contains(h5dump(file, "-d " + path), text);
  };
  EXPECT_TRUE(shows("/cells/seed", "(0): 1, 2, 1, 2"));
  EXPECT_TRUE(shows("/cells/state", "(0): 0, 1, 0, 2"));
  EXPECT_TRUE(shows("/cells/combination", "(0): 0, 0, 1, 1"));
  EXPECT_TRUE(shows("/cells/metrics", "(3,0): 30, nan"));
  EXPECT_TRUE(shows("/cells/metric_names", "distance_m"));
  EXPECT_TRUE(shows("/combinations/lidar.range_max", "8"));
  EXPECT_TRUE(shows("/kidnaps/cell", "(0): 0, 0, 1, 1, 2, 2, 3, 3"));
  EXPECT_TRUE(shows("/kidnaps/kind", "(0): 0, 1, 0, 1, 0, 1, 0, 1"));
  EXPECT_TRUE(shows("/kidnaps/to", "(0,0): 1, 2, 0.5"));
  EXPECT_TRUE(shows("/kidnaps/time_s", "(0): 1.5, nan"));
  EXPECT_TRUE(shows("/kidnaps/kinds", "carry"));
}

TEST_F(CampaignTablesTest, CostsAreInAFileOfTheirOwn) {
  CellRows index = rows();
  write_costs(index, folder_.path() / "c.csv");
  EXPECT_TRUE(contains(read_file(folder_.path() / "c.csv"), "\n2,0.250000,0.000000,0.0\n"));
}

TEST_F(CampaignTablesTest, CellsThatWereNotNeededAreLeftOut) {
  const CampaignSpec larger =
      load_campaign_spec(folder_.put("l.yaml",
                                     "scenario: {world: lab}\ngrid: {lidar.range_max: [4, 8]}\n"
                                     "seeds: 3\nuntil: {metric: a, width: 1, first: 2}\n"),
                         FilePrograms::kRefused);
  CellRows index(folder_.path(), larger.cells());
  EXPECT_EQ(campaign_summary(larger, index).at("cells"), 4);
}

}  // namespace
}  // namespace castaway::testbed
