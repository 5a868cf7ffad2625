// castaway campaign: grids of values and seeds.
#include <chrono>

#include "localization/geometry/random.hpp"
#include "tests/program/campaign_files.hpp"
#include "tests/program/killed.hpp"

namespace castaway::test {
namespace {

TEST(Campaign, MakesACellForEveryCombinationAndSeed) {
  const fs::path folder = folder_with_grid();
  const Outcome made = castaway(folder, "campaign s.yaml --out c -j 2");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.err, "");
  expect_contains(made.out, "lidar.range_max = 3, localizers = [mh_amcl]\n  mh_amcl: ");
  expect_contains(made.out, " of 3 recovered (");
  expect_contains(made.out, "Folder: c\n");
  EXPECT_EQ(lines_of(folder / "c/results.csv"), 13);
  EXPECT_EQ(lines_of(folder / "c/kidnaps.csv"), 13);
  EXPECT_EQ(lines_of(folder / "c/costs.csv"), 13);
  const std::string results = text_of(folder / "c/results.csv");
  expect_contains(results, "cell,name,seed,lidar.range_max,localizers,events.0.kidnap.at_s,state");
  expect_contains(results, "\n11,");
  const Outcome again = castaway(folder, "campaign s.yaml --out c -j 2");
  EXPECT_EQ(again.out, made.out);
}

TEST(Campaign, StopsWhereTheIntervalIsNarrow) {
  const fs::path folder = folder_with_spec(std::string(kGrid).replace(
      std::string(kGrid).find("seeds: 3"), 8,
      "seeds: 8\nuntil: {metric: mh_amcl.recovery.success, width: 0.9, first: 2}"));
  for (const char* line :
       {"campaign s.yaml --out one -j 2", "campaign s.yaml --out two --shard 1/3",
        "campaign s.yaml --out two --shard 2/3", "campaign s.yaml --out two --shard 3/3"}) {
    ASSERT_EQ(castaway(folder, line).exit_code, 0) << line;
  }
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out two --collect").exit_code, 0);
  expect_same_tables(folder / "one", folder / "two");
  // amcl's cells have no mh_amcl, so that they go on to the last seed.
  const int cells = lines_of(folder / "one/results.csv") - 1;
  EXPECT_GT(cells, 16);
  EXPECT_LT(cells, 32);
}

// A campaign may take hours; these are known to be wrong before.
TEST(Campaign, RefusesMetricsAndRankingsBeforeTheFirstCell) {
  const fs::path folder =
      folder_with_grid("until: {metric: mh_amcl.recovery.succes, width: 0.1}\n");
  expect_refused(castaway(folder, "campaign s.yaml --out c"),
                 {"s.yaml", "until", "mh_amcl.recovery.success"});
  write(folder / "flat.yaml", "scenario: {world: room.yaml}\nseeds: 2\n");
  expect_refused(castaway(folder, "campaign flat.yaml --out c --rank"), {"flat.yaml", "grid"});
  EXPECT_FALSE(fs::exists(folder / "c"));
}

TEST(Campaign, RanksTheKeys) {
  const fs::path folder = folder_with_spec(std::string(kGrid).replace(
      std::string(kGrid).find("  localizers: [[mh_amcl], [amcl]]"), 33, "  people.count: [0, 1]"));
  const Outcome ranked = castaway(folder, "campaign s.yaml --out c -j 2 --rank");
  ASSERT_EQ(ranked.exit_code, 0) << ranked.err;
  expect_contains(ranked.out, "position_error_m.rmse, over 3 seeds: shares of its variance");
  const std::string table = text_of(folder / "c/ranks.csv");
  expect_contains(table, "metric,key,first,first_low,first_high,total,total_low,total_high,seeds");
  expect_contains(table, "position_error_m.rmse,lidar.range_max,");
  expect_contains(table, "position_error_m.rmse,seed,");
  expect_refused(castaway(folder, "campaign s.yaml --out c --metric nothing"),
                 {"unknown metric 'nothing'"});
}

TEST(Campaign, ShardsGiveTheSameTables) {
  const fs::path folder = folder_with_grid();
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out whole").exit_code, 0);
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out parts --shard 1/3 -j 2").exit_code, 0);
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out parts --shard 3/3").exit_code, 0);
  const Outcome early = castaway(folder, "campaign s.yaml --out parts --collect");
  EXPECT_EQ(early.exit_code, 1);
  expect_contains(early.err, "cells are missing: 1, 4, 7, 10;");
  EXPECT_FALSE(fs::exists(folder / "parts/results.csv"));
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out parts --shard 2/3").exit_code, 0);
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out parts --collect").exit_code, 0);
  expect_same_tables(folder / "whole", folder / "parts");
}

// CASTAWAY_KILLS sets the number of kills.
TEST(Campaign, KilledAtAnyMomentItGoesOnAndComesOutTheSame) {
  const fs::path folder = folder_with_grid();
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out whole -j 2").exit_code, 0);
  const auto whole = std::chrono::steady_clock::now() - begin;
  const auto most = std::chrono::duration_cast<std::chrono::microseconds>(whole).count();
  localization::Rng rng = localization::substream(1, "kills");
  int killed = 0;
  for (int tries = 0; killed < wanted_kills() && tries < 1000; ++tries) {
    const auto wait =
        std::chrono::microseconds(rng() % static_cast<std::uint64_t>(std::max<long>(most, 1)));
    const bool in_time =
        killed_after(folder, {"campaign", "s.yaml", "--out", "parts", "-j", "2"}, wait);
    killed += in_time ? 1 : 0;
    if (in_time) continue;
    expect_same_tables(folder / "whole", folder / "parts");
    fs::remove_all(folder / "parts");
  }
  const Outcome last = castaway(folder, "campaign s.yaml --out parts -j 2");
  ASSERT_EQ(last.exit_code, 0) << last.err;
  expect_same_tables(folder / "whole", folder / "parts");
  EXPECT_FALSE(fs::exists(folder / "parts/.work-rows.jsonl"));
}

// The program fails in the cells of one seed, until it is mended.
TEST(Campaign, RecordsACellThatFailsAndGoesOn) {
  const fs::path folder = folder_with_spec(R"(name: failing
scenario:
  world: room.yaml
  duration_s: 2
  physics: kinematic
  events: []
  localizers: [{name: mine, program: [sh, mine.sh]}, amcl]
seeds: 2
keep: failures
)");
  std::ofstream(folder / "mine.sh") << "exit 7\n";
  const Outcome refused = castaway(folder, "campaign s.yaml --out c");
  expect_refused(refused, {"--allow-programs"});
  EXPECT_FALSE(fs::exists(folder / "c"));
  const Outcome made = castaway(folder, "campaign s.yaml --out c --allow-programs");
  EXPECT_EQ(made.exit_code, 1);
  expect_contains(made.err, "castaway: cell 1 failed: ");
  expect_contains(made.err, "castaway campaign s.yaml --only 1 --out again plays it");
  expect_contains(made.out, "not scored: 0 void, 2 failed");
  EXPECT_EQ(lines_of(folder / "c/rows.jsonl"), 2);
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c --allow-programs").exit_code, 1);
  EXPECT_EQ(lines_of(folder / "c/rows.jsonl"), 2);
  const fs::path cell = fs::directory_iterator(folder / "c/cells")->path();
  std::ofstream(cell / "notes.txt") << "mine";
  const std::string errors = text_of(cell / "errors.csv");
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c --allow-programs --retry-failed").exit_code,
            1);
  EXPECT_EQ(text_of(cell / "notes.txt"), "mine");
  EXPECT_EQ(text_of(cell / "errors.csv"), errors);
  EXPECT_EQ(lines_of(folder / "c/rows.jsonl"), 4);
  EXPECT_EQ(lines_of(folder / "c/results.csv"), 3);
}

TEST(Campaign, KeepsWhatIsAskedFor) {
  const fs::path folder = folder_with_grid("keep: failures\n");
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c -j 2").exit_code, 0);
  const std::string kidnaps = text_of(folder / "c/kidnaps.csv");
  int kept = 0;
  for (const auto& entry : fs::directory_iterator(folder / "c/cells")) {
    EXPECT_TRUE(fs::exists(entry.path() / "errors.csv"));
    ++kept;
  }
  EXPECT_GT(kept, 0);  // `amcl` does not recover.
  EXPECT_LT(kept, 12);
  const fs::path errors = folder_with_grid("keep: errors\n");
  ASSERT_EQ(castaway(errors, "campaign s.yaml --out c -j 2").exit_code, 0);
  const auto cells = fs::directory_iterator(errors / "c/cells");
  EXPECT_EQ(std::distance(cells, {}), 12);
}

TEST(Campaign, PlaysACellAgainInFull) {
  const fs::path folder = folder_with_grid("keep: folder\n");
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c -j 2").exit_code, 0);
  const Outcome again = castaway(folder, "campaign s.yaml --only 11 --out again");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(fs::exists(folder / "again/report.html"));
  fs::path cell;
  for (const auto& entry : fs::directory_iterator(folder / "c/cells")) {
    if (entry.path().filename().string().starts_with("000011-")) cell = entry.path();
  }
  EXPECT_EQ(text_of(cell / "errors.csv"), text_of(folder / "again/errors.csv"));
  EXPECT_EQ(text_of(cell / "summary.json"), text_of(folder / "again/summary.json"));
  expect_refused(castaway(folder, "campaign s.yaml --only 12 --out more"), {"cells 0 to 11"});
}

TEST(Campaign, IsAGate) {
  const fs::path folder = folder_with_grid(
      "expect: {amcl.recovery.success: {is: \">= 1\", for: mean}, mh_amcl.availability: \"> "
      "0\"}\n");
  const Outcome made = castaway(folder, "campaign s.yaml --out c -j 2");
  EXPECT_EQ(made.exit_code, 3);
  expect_contains(made.out, "not met: amcl.recovery.success");
}

TEST(Campaign, RefusesWhatItDidNotMake) {
  const fs::path folder = folder_with_grid();
  fs::create_directories(folder / "mine");
  std::ofstream(folder / "mine/notes.txt") << "mine";
  expect_refused(castaway(folder, "campaign s.yaml --out mine"), {"notes.txt", "--out"});
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c -j 2").exit_code, 0);
  std::ofstream(folder / "c/results.csv", std::ios::app) << "a remark\n";
  expect_refused(castaway(folder, "campaign s.yaml --out c"), {"results.csv", "changed"});
  std::ofstream(folder / "s.yaml", std::ios::app) << "timeout_s: 100\n";
  expect_refused(castaway(folder, "campaign s.yaml --out c"), {"another specification"});
  EXPECT_EQ(text_of(folder / "mine/notes.txt"), "mine");
}

TEST(Campaign, NoticesThatAWorldHasChanged) {
  const fs::path folder = folder_with_grid();
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out c -j 2").exit_code, 0);
  std::ofstream(folder / "room.pgm", std::ios::app) << "255\n";
  expect_refused(castaway(folder, "campaign s.yaml --out c"), {"worlds, robots or logs"});
}

TEST(Campaign, RefusesBadSpecificationsInOneLine) {
  const fs::path folder = folder_with_grid("keep: everything\n");
  expect_refused(castaway(folder, "campaign s.yaml --out c"), {"s.yaml:", "keep", "summary"});
  std::ofstream(folder / "t.yaml") << "scenario: {world: room.yaml}\ngrid: {lidar.range_mx: [3]}\n";
  expect_refused(castaway(folder, "campaign t.yaml --out c"),
                 {"t.yaml:2", "range_mx", "range_max"});
  std::ofstream(folder / "u.yaml") << "scenario: {world: room.yaml}\nseeds: none\n";
  expect_refused(castaway(folder, "campaign u.yaml --out c"), {"u.yaml:2", "seeds"});
  expect_refused(castaway(folder, "campaign t.yaml --out c --shard 4/3"), {"--shard"});
  expect_refused(castaway(folder, "campaign t.yaml"), {"--out"});
  EXPECT_FALSE(fs::exists(folder / "c"));
}

}  // namespace
}  // namespace castaway::test
