// Tests castaway twin: what localizers do on a log beside what they do in its twin.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"
#include "tests/tools/support/recorded_office.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kQuick =
    " --localizer mh_amcl --localizer amcl --starts 2 --kidnaps 1 --window 8 ";

fs::path folder_with_offices() {
  const fs::path folder = fresh_folder();
  testbed::write_office(testbed::recorded_office(150), folder / "first");
  testbed::write_office(testbed::recorded_office(200), folder / "second");
  return folder;
}

TEST(TwinCommand, ComparesLocalizersOnLogsAndTheirTwins) {
  const fs::path folder = folder_with_offices();
  const Outcome outcome =
      castaway(folder, std::string("twin first second") + kQuick + "--out twins -j 2");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "mh_amcl");
  expect_contains(outcome.out, "Page: twins/twin.html");
  const Json found = Json::parse(text_of(folder / "twins/twin.json"));
  ASSERT_EQ(found.at("rows").size(), 4U);
  for (const Json& row : found.at("rows")) {
    for (const char* side : {"on_log", "in_twin"}) {
      EXPECT_EQ(row.at(side).at("starts").at("trials"), 2);
      EXPECT_EQ(row.at(side).at("kidnaps").at("trials"), 1);
      EXPECT_LT(row.at(side).at("tracking_no_alarm_m"), 0.1);
    }
  }
  const Json& mh_amcl = found.at("localizers").at(0);
  EXPECT_EQ(mh_amcl.at("localizer"), "mh_amcl");
  EXPECT_EQ(mh_amcl.at("measured"), 1.0);
  EXPECT_EQ(mh_amcl.at("predicted"), 1.0);
  EXPECT_EQ(mh_amcl.at("tracked"), 2);
  for (const char* log : {"first", "second"}) {
    EXPECT_TRUE(fs::exists(folder / "twins/twins" / log / "scenario.yaml"));
    expect_contains(text_of(folder / "twins/twin.html"),
                    std::string("twins/") + log + "/calibration.html");
  }
}

TEST(TwinCommand, GivesTheSameResultsWithAnyNumberOfJobs) {
  const fs::path folder = folder_with_offices();
  const std::string line = std::string("twin first second") + kQuick + "--json ";
  const auto results = [&](const std::string& options) {
    const Outcome outcome = castaway(folder, line + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    Json json = Json::parse(outcome.out);
    for (Json& row : json.at("rows")) {
      for (const char* side : {"on_log", "in_twin"}) {
        row.at(side).erase("cpu_mean_ms");
        row.at(side).erase("cpu_max_ms");
      }
    }
    return json;
  };
  EXPECT_EQ(results("--out a"), results("--out b -j 2"));
}

TEST(TwinCommand, RefusesWhatItCannotUse) {
  const fs::path folder = folder_with_offices();
  expect_refused(castaway(folder, "twin first nowhere --out twins"), {"nowhere"});
  expect_refused(castaway(folder, "twin first nowhere --out twins -j 2"), {"nowhere"});
  EXPECT_FALSE(fs::exists(folder / "twins"));
  fs::create_directories(folder / "other");
  fs::copy(folder / "first", folder / "other/first");
  expect_refused(castaway(folder, "twin first other/first --out twins"), {"two logs", "'first'"});
  expect_refused(castaway(folder, "twin first --localizer nobody --out twins"), {"nobody"});
  write(folder / "mine/notes.txt", "keep");
  expect_refused(castaway(folder, "twin first --out mine"), {"mine"});
  EXPECT_EQ(text_of(folder / "mine/notes.txt"), "keep");
}

}  // namespace
}  // namespace castaway::test
