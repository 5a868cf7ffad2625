#include "tools/pages/runs/pooled_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/pages/runs/recoveries_section.hpp"
#include "tools/pages/runs/runs_table.hpp"
#include "tools/pages/runs/verdict_words.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// A localizer with a kidnap at 5 s of a run of 30 s; nothing: it did not recover.
Json kidnapped_once(std::optional<double> time_s) {
  const Json time = time_s ? Json(*time_s) : Json();
  const Json window{{"kind", "teleport"},
                    {"taken_s", 5.0},
                    {"at_s", 5.0},
                    {"scored", true},
                    {"recovered", time_s.has_value()},
                    {"time_s", time},
                    {"distance_m", time}};
  return {{"tracking_error_m", {{"mean", 0.25}}},
          {"recovery",
           {{"events", 1},
            {"recovered", time_s ? 1 : 0},
            {"time_s", {{"max", time}}},
            {"each", {window}}}},
          {"wrong_lock_share", 0.5}};
}

SetRun set_run(std::uint64_t seed, const Json& localizers) {
  return {"runs/seed-" + std::to_string(seed),
          {{"scenario", "s"}, {"duration_s", 30.0}, {"localizers", localizers}},
          "s",
          seed,
          false};
}

/// In `count` runs "mh_amcl" recovers after 1, 2, ... s, and "amcl" never.
RunSet one_sided_set(int count) {
  RunSet set{{}, {"mh_amcl", "amcl"}};
  for (int i = 0; i < count; ++i) {
    set.runs.push_back(
        set_run(static_cast<std::uint64_t>(i + 1),
                {{"mh_amcl", kidnapped_once(i + 1.0)}, {"amcl", kidnapped_once(std::nullopt)}}));
  }
  return set;
}

TEST(PooledTable, HasARowForEachLocalizerWithItsIntervals) {
  const std::string html = pooled_table(one_sided_set(8));
  EXPECT_TRUE(contains(html, "<span>8 of 8<br><small>67.6 to 100 %</small></span>"));
  EXPECT_TRUE(contains(html, "<span>0 of 8<br><small>0 to 32.4 %</small></span>"));
  EXPECT_TRUE(contains(html, "data-head=\"time to recovery\"><span>4.50 s<br>"));
  EXPECT_TRUE(contains(html, "data-head=\"slowest\"><span>8.00 s</span>"));
  EXPECT_TRUE(contains(html, "<span>50.0 %<br><small>50.0 to 50.0 %</small></span>"));
  EXPECT_TRUE(contains(html, "<span>0.250 m<br>"));
  EXPECT_TRUE(contains(html, "<line class=\"c1\""));
}

// Of 8 pairs all in one direction McNemar's p is 2^-7; of 4 it is 2^-3.
TEST(RecoveryVerdicts, SayWhoRecoversMoreOftenOnlyIfItIsSignificant) {
  auto verdicts = recovery_verdicts(one_sided_set(8));
  EXPECT_EQ(verdicts["mh_amcl"], "recovers more often than amcl (p = 0.008)");
  EXPECT_EQ(verdicts["amcl"], "recovers less often than mh_amcl (p = 0.008)");
  RunSet alike = one_sided_set(6);
  for (SetRun& run : alike.runs) run.summary["localizers"]["amcl"] = kidnapped_once(1.0);
  EXPECT_EQ(recovery_verdicts(alike)["amcl"], "no difference to mh_amcl seen (p = 1.000)");
  EXPECT_EQ(p_text(0.0001), "p < 0.001");
}

// Of 5 pairs all in one direction p is 2^-4, of 6 it is 2^-5; 3 pairs of localizers take 2^-6 / 3.
TEST(RecoveryVerdicts, SayHowManyKidnapsItTakes) {
  EXPECT_EQ(recovery_verdicts(one_sided_set(5))["mh_amcl"],
            "too few kidnaps to tell it from amcl: 5, it takes 6");
  EXPECT_EQ(recovery_verdicts(one_sided_set(6))["mh_amcl"],
            "recovers more often than amcl (p = 0.031)");
  RunSet three = one_sided_set(6);
  three.localizers.push_back("third");
  for (SetRun& run : three.runs) run.summary["localizers"]["third"] = kidnapped_once(1.0);
  EXPECT_EQ(recovery_verdicts(three)["third"],
            "too few kidnaps to tell it from mh_amcl: 6, it takes 7; too few kidnaps to tell it "
            "from amcl: 6, it takes 7");
}

TEST(RecoveryVerdicts, LeaveOutVoidRunsAndOtherKidnaps) {
  RunSet set = one_sided_set(9);
  set.runs[0].is_void = true;
  set.runs[1].summary["localizers"]["amcl"]["recovery"]["each"][0]["at_s"] = 5.5;
  EXPECT_EQ(recovery_verdicts(set)["amcl"], "recovers less often than mh_amcl (p = 0.016)");
  set.localizers = {"amcl"};
  EXPECT_TRUE(recovery_verdicts(set).empty());
}

// 8 kidnaps; the chart is 25 s wide, as those without recovery are observed to the end of the run.
TEST(RecoveriesChart, RisesWithEveryRecovery) {
  const std::string html = recoveries_chart(one_sided_set(8));
  EXPECT_TRUE(contains(html, "mh_amcl: 8 of 8</span>"));
  EXPECT_TRUE(contains(html, "amcl: 0 of 8</span>"));
  // 1 s is 25.6 px, 12.5 % are 32 px.
  EXPECT_TRUE(contains(html, "d=\"M64.0 268.0L89.6 268.0L89.6 236.0L115.2 236.0L115.2 204.0"));
  EXPECT_TRUE(contains(html, "d=\"M64.0 268.0L704.0 268.0\""));
  // The interval of 7 of 8 not yet recovered is 0.387 to 0.981 (Greenwood, log-log).
  EXPECT_TRUE(contains(html, " 89.6,111.1 "));
  EXPECT_TRUE(contains(html, " 89.6,263.2 "));
  EXPECT_TRUE(contains(html, "time since the kidnap [s]"));
  EXPECT_EQ(recoveries_chart(RunSet{}), "");
}

TEST(RunsTable, MarksWhatWentWrong) {
  RunSet set = one_sided_set(2);
  set.runs[1].is_void = true;
  const DataTable table = runs_table(set, {7}, "runs/index.html");
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.head[2], "mh_amcl recovered");
  const auto& row = table.rows[0];
  EXPECT_EQ(row[0].html, "<a href=\"seed-1/report.html\">seed 1</a>");
  EXPECT_EQ(row[1].html, "<span class=\"bad\">1</span>");
  EXPECT_EQ(row[2].text, "1 of 1");
  EXPECT_EQ(row[2].html, "");
  EXPECT_EQ(row[5].html, "<span class=\"bad\">0 of 1</span>");
  EXPECT_EQ(row[4].value, 0.25);
  EXPECT_EQ(table.rows[1][1].html, "<span class=\"bad\">void</span>");
  EXPECT_EQ(table.rows[2][0].value, 7.0);
  EXPECT_EQ(table.rows[2][1].html, "<span class=\"bad\">run failed</span>");
  EXPECT_EQ(table.rows[2].size(), table.head.size());
}

}  // namespace
}  // namespace castaway::testbed
