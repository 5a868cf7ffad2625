// Tests castaway settings: the page of the docs, and the settings of a saved run.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

TEST(SettingsCommand, GivesThePageOfTheDocs) {
  const Outcome outcome = castaway(fresh_folder(), "settings --markdown");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = text_of(fs::path(CASTAWAY_SOURCE_DIR) / "docs/settings.md");
  const std::size_t begin = page.find("\n## ");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(page.substr(begin), outcome.out)
      << "run: castaway settings --markdown, and put it into docs/settings.md";
}

TEST(SettingsCommand, ListsWhatBeginsSo) {
  const Outcome outcome = castaway(fresh_folder(), "settings odometry.slip --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto settings = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(settings.size(), 6U);
  EXPECT_EQ(settings[0].at("key"), "odometry.slip.rate_per_m");
  EXPECT_EQ(settings[0].at("unit"), "1/m");
  expect_refused(castaway(fresh_folder(), "settings odometri"), {"odometri", "castaway settings"});
}

TEST(SettingsCommand, ASavedRunHoldsEverySettingOfItsLocalizers) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder,
               "run --duration 1 --set outputs.snapshots=false --set outputs.report=false "
               "--set 'localizers=[mh_amcl, mh_amcl: {mode: paper}]' --out run");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string saved = text_of(folder / "run/scenario.yaml");
  for (const char* key : {"false_alarms_per_h:", "deep_candidates:", "suspicious_doubt:", "stays:",
                          "match_period_s:", "threshold:", "destroy_below:"}) {
    expect_contains(saved, key);
  }
  EXPECT_EQ(castaway(folder, "run run/scenario.yaml --out again").exit_code, 0);
  EXPECT_EQ(text_of(folder / "again/errors.csv"), text_of(folder / "run/errors.csv"));
  EXPECT_EQ(text_of(folder / "again/scenario.yaml"), saved);
}

}  // namespace
}  // namespace castaway::test
