#include "localization/paper/paper_mh_amcl.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/grid_drive.hpp"

namespace castaway::localization {
namespace {

using test::kForward;
using test::known_start;
using test::kStart;

TEST(PaperMhAmcl, TracksFromAKnownStart) {
  PaperMhAmcl localizer({}, test::office(), 1);
  localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 60; ++i) drive.step(localizer, kForward);
  ASSERT_TRUE(localizer.estimate());
  EXPECT_LT(distance(localizer.estimate()->T_map_base, drive.truth()), 0.2);
  EXPECT_GT(localizer.estimate()->quality, 0.3);
  EXPECT_EQ(localizer.estimate()->probability, localizer.estimate()->quality);
  EXPECT_EQ(localizer.estimate()->lost, localizer.estimate()->quality < 0.5);
}

TEST(PaperMhAmcl, FindsItselfWhereTheCascadesOrientationsAllow) {
  PaperMhAmcl localizer({}, test::office(), 1);
  test::GridDrive drive(test::office(), kStart);  // its yaw of 0 is one of the headings
  drive.step(localizer, {});
  ASSERT_TRUE(localizer.estimate());
  EXPECT_LT(distance(localizer.estimate()->T_map_base, drive.truth()), 0.3);
}

TEST(PaperMhAmcl, HasNoPopulationWhereTheCascadeFindsNothing) {
  OccupancyGrid empty = test::office();
  empty.cells.assign(empty.cells.size(), CellState::kFree);
  PaperMhAmcl localizer({}, empty, 1);
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 5; ++i) drive.step(localizer, kForward);
  EXPECT_FALSE(localizer.estimate());
}

TEST(PaperMhAmcl, MatchesEveryFewSeconds) {
  int matches = 0;
  PaperStages stages = paper_stages({}, test::office());
  stages.match = [&matches](const MatchScan&) {
    ++matches;
    return std::vector<Candidate>{};
  };
  PaperMhAmcl localizer({}, stages, 1);
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 31; ++i) drive.step(localizer, {});
  EXPECT_EQ(matches, 2);  // at 0.1 s and 3.1 s
}

TEST(PaperMhAmcl, ListsCandidatesThatAreGoodAndApartUpToTheMost) {
  PaperStages stages = paper_stages({}, test::office());
  stages.match = [](const MatchScan&) {
    std::vector<Candidate> found;
    for (int i = 0; i < 9; ++i) found.push_back({{1.0 + 0.4 * i, 3.0, 0.0}, 0.9 - 0.01 * i});
    return found;
  };
  stages.destroy = [](Populations&) {};
  PaperMhAmclConfig config;
  config.rules.apart_m = 0.7;
  config.rules.most = 3;
  PaperMhAmcl localizer(config, stages, 1);
  test::GridDrive drive(test::office(), kStart);
  drive.step(localizer, {});
  const auto populations = localizer.diagnostics().populations;
  ASSERT_EQ(populations.size(), 3U);  // at 1.0 m, 1.8 m, 2.6 m
  EXPECT_NEAR(populations[1].T_map_base.x, 1.8, 0.2);
  EXPECT_NEAR(populations[2].T_map_base.x, 2.6, 0.2);
  config.rules.candidate_from = 0.895;
  PaperMhAmcl strict(config, stages, 1);
  test::GridDrive again(test::office(), kStart);
  again.step(strict, {});
  EXPECT_EQ(strict.diagnostics().populations.size(), 1U);
}

TEST(PaperMhAmcl, ReportsTheCostOfItsStages) {
  std::chrono::nanoseconds time{};
  PaperMhAmcl localizer({}, test::office(), 1,
                        [&time] { return time += std::chrono::nanoseconds(5); });
  localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 3; ++i) drive.step(localizer, kForward);
  const auto cost = localizer.diagnostics().cpu_by_stage;
  EXPECT_EQ(cost.at("correct").count(), 3 * 5);
  EXPECT_EQ(cost.at("match").count(), 5);
}

TEST(PaperMhAmcl, RefusesSettingsAndMapsThatMakeNoSense) {
  PaperMhAmclConfig config;
  config.match_period_s = 0.0;
  EXPECT_THROW(PaperMhAmcl(config, test::office(), 1), std::invalid_argument);
  config = {};
  config.reseed.winners = 0.0;
  EXPECT_THROW(PaperMhAmcl(config, test::office(), 1), std::invalid_argument);
  EXPECT_THROW(PaperMhAmcl({}, OccupancyGrid{}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
