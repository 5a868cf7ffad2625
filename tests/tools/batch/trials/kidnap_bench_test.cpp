#include "tools/batch/trials/kidnap_bench.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/stages/spaces.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

const KidnapTrials& lab() {
  static const KidnapTrials trials({.lead_s = 0.5, .window_s = 3.0});
  return trials;
}

std::vector<const sim::WorldObject*> people_in(const KidnapTrial& trial) {
  std::vector<const sim::WorldObject*> people;
  for (const sim::WorldObject& object : trial.simulation.world.objects) {
    if (object.name.starts_with("person_")) people.push_back(&object);
  }
  return people;
}

TEST(KidnapTrials, LeadFarAwayAndLastForTheWindow) {
  for (int index = 0; index < 10; ++index) {
    const KidnapTrial trial = lab().draw(index, 0);
    ASSERT_EQ(trial.simulation.events.kidnaps.size(), 1U);
    const sim::KidnapSpec& kidnap = trial.simulation.events.kidnaps[0];
    EXPECT_GE((kidnap.target->position() - trial.simulation.start.position()).norm(), 3.0);
    EXPECT_LE(kidnap.when.value, 1.0);
    EXPECT_NEAR(seconds(trial.simulation.duration), kidnap.when.value + 3.0, 1e-6);
    EXPECT_TRUE(people_in(trial).empty());
  }
}

TEST(KidnapTrials, PutPeopleAroundTheTargetWhoAreOnNoMap) {
  const KidnapTrial trial = lab().draw(3, 6);
  const auto people = people_in(trial);
  ASSERT_EQ(people.size(), 6U);
  const Eigen::Vector2d target = trial.simulation.events.kidnaps[0].target->position();
  for (const sim::WorldObject* person : people) {
    const double away = (person->T_map_object.translation().head<2>() - target).norm();
    EXPECT_GE(away, 0.6);
    EXPECT_LE(away, 4.0);
    EXPECT_FALSE(person->in_map);
  }
}

/// Free spaces are shared by trials in the same world, and people make another one.
TEST(KidnapTrials, WithPeopleDoNotDependOnThoseBefore) {
  const KidnapTrials alone({.lead_s = 0.5, .window_s = 3.0});
  const KidnapTrial expected = alone.draw(7, 12);
  for (int index = 0; index < 7; ++index) {
    const KidnapTrial before = lab().draw(index, 12);
    before.simulation.spaces->landing(before.simulation, 0.2);
  }
  const KidnapTrial trial = lab().draw(7, 12);
  EXPECT_EQ(trial.simulation.spaces->landing(trial.simulation, 0.2).grid().cells,
            expected.simulation.spaces->landing(expected.simulation, 0.2).grid().cells);
  EXPECT_EQ(lab().draw(0, 0).simulation.spaces, lab().draw(1, 0).simulation.spaces);
}

TEST(KidnapTrials, DependOnSeedAndNumberOnly) {
  const KidnapTrials again({.lead_s = 0.5, .window_s = 3.0});
  const KidnapTrials other({.lead_s = 0.5, .window_s = 3.0, .seed = 2});
  EXPECT_EQ(lab().draw(5, 0).simulation.start, again.draw(5, 0).simulation.start);
  EXPECT_EQ(lab().draw(5, 0).simulation.start, again.draw(5, 3).simulation.start);
  EXPECT_EQ(lab().draw(5, 0).seed, again.draw(5, 0).seed);
  EXPECT_NE(lab().draw(5, 0).simulation.start, other.draw(5, 0).simulation.start);
  EXPECT_NE(lab().draw(5, 0).simulation.start, lab().draw(6, 0).simulation.start);
}

TEST(KidnapTrials, RefuseFiguresOutOfTheirRange) {
  EXPECT_THROW(KidnapTrials({.window_s = 0.0}), std::invalid_argument);
  EXPECT_THROW(KidnapTrials({.lead_s = 0.1}), std::invalid_argument);
  EXPECT_THROW(KidnapTrials({.world = "nowhere"}), std::runtime_error);
}

TEST(KidnapTrials, HaveTheKindAndTheLidarThatAreAskedFor) {
  const KidnapTrials trials({.lead_s = 0.5,
                             .window_s = 3.0,
                             .kind = sim::KidnapKind::kLookAlike,
                             .min_distance_m = 1.0,
                             .lidar = "urg-04lx",
                             .range_max = 5.6});
  const KidnapTrial trial = trials.draw(0, 0);
  EXPECT_EQ(trial.simulation.events.kidnaps[0].kind, sim::KidnapKind::kLookAlike);
  EXPECT_EQ(trial.simulation.events.kidnaps[0].min_distance_m, 1.0);
  EXPECT_EQ(trial.simulation.lidars[0].range_max, 5.6);
  EXPECT_EQ(trial.simulation.lidars[0].beams, 682);
  EXPECT_THROW(trials.draw(0, 3), std::invalid_argument);
  EXPECT_THROW(KidnapTrials({.kind = sim::KidnapKind::kSpin}), std::invalid_argument);
  EXPECT_EQ(lab().draw(0, 0).simulation.lidars[0].range_max, 12.0);
}

TEST(PlayKidnaps, JudgesLocalizersOnTheSameRuns) {
  const std::vector<LocalizerSpec> specs = {parse_localizer("mh_amcl"), parse_localizer("amcl")};
  int played = 0;
  const auto reports = play_kidnaps(lab(), specs, {2, 0, run_at_once(2)}, [&] { ++played; });
  EXPECT_EQ(played, 2);
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[1].index, 1);
  EXPECT_TRUE(reports[0].search.rank);
  for (const KidnapReport& report : reports) {
    EXPECT_GE(distance(report.T_map_from, report.T_map_to), 3.0);
    ASSERT_EQ(report.outcomes.size(), 2U);
    EXPECT_EQ(report.outcomes[0].since_kidnap.scans, report.outcomes[1].since_kidnap.scans);
    EXPECT_NEAR(static_cast<double>(report.outcomes[0].since_kidnap.scans), 30.0, 1.0);
    EXPECT_TRUE(report.outcomes[0].recovered_s);
    EXPECT_FALSE(report.outcomes[1].alarm_s);
    ASSERT_TRUE(report.distinguishable);  // the laboratory has no places that look alike
    const WrongScans& since = report.outcomes[0].since_distinguishable;
    EXPECT_GT(since.scans, 0);
    EXPECT_LT(since.scans, report.outcomes[0].since_kidnap.scans);
  }
}

TEST(PlayKidnaps, RepeatsItself) {
  const std::vector<LocalizerSpec> specs = {parse_localizer("mh_amcl")};
  const auto recovered = [&] {
    return play_kidnaps(lab(), specs, {1, 3, run_at_once(1)}).at(0).outcomes.at(0).recovered_s;
  };
  EXPECT_EQ(recovered(), recovered());
}

}  // namespace
}  // namespace castaway::testbed
