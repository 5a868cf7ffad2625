// Tests castaway bench kidnaps.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

TEST(BenchKidnaps, PrintsALineForEveryBatchAndLocalizer) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder, "bench kidnaps --kidnaps 1 --window 3 --lead 1 --obstacles 0 --obstacles 3");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1 + 2 * 3) << outcome.out;
  expect_contains(outcome.out, "matcher");
  expect_contains(outcome.out, " amcl ");
  expect_contains(outcome.out, "since distinguishable: wrong, longest");
}

TEST(BenchKidnaps, PrintsJsonAndRepeatsItself) {
  const fs::path folder = fresh_folder();
  const std::string arguments =
      "bench kidnaps --kidnaps 2 --window 3 --lead 1 --localizer mh_amcl --seed 3 --json";
  const Outcome outcome = castaway(folder, arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(castaway(folder, arguments).out, outcome.out);
  EXPECT_EQ(castaway(folder, arguments + " -j 2").out, outcome.out);
  const Json batches = Json::parse(outcome.out);
  ASSERT_EQ(batches.size(), 1U);
  EXPECT_EQ(batches[0].at("kidnaps"), 2);
  EXPECT_EQ(batches[0].at("/top5/count"_json_pointer), 2);
  EXPECT_EQ(batches[0].at("/localizers/mh_amcl/recovered/count"_json_pointer), 2);
  EXPECT_LT(batches[0].at("/localizers/mh_amcl/tracking_m"_json_pointer), 0.1);
  const Json& distinct = batches[0].at("/localizers/mh_amcl/distinguishable"_json_pointer);
  EXPECT_EQ(distinct.at("share"), 1.0);
  EXPECT_LE(distinct.at("wrong_share"), 1.0);
  EXPECT_GE(distinct.at("longest_wrong_s"), 0.0);
}

/// Share of the scans after kidnaps to look-alikes, seen with 240 degrees and 5.6 m, that are wrong
/// and confident.
double wrong_after_look_alikes(const std::string& world) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder,
               "bench kidnaps --kind look-alike --min-distance 1 --lidar urg-04lx "
               "--range-max 5.6 --kidnaps 8 --localizer mh_amcl --json --world " +
                   world);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json localizer = Json::parse(outcome.out)[0].at("/localizers/mh_amcl"_json_pointer);
  EXPECT_EQ(localizer.at("/recovered/count"_json_pointer), 8) << world;
  EXPECT_LE(localizer.at("longest_wrong_s"), 5.0) << world;
  return localizer.at("wrong_lock_share");
}

TEST(BenchKidnaps, MhAmclNoticesKidnapsToLookAlikes) {
  EXPECT_LT(wrong_after_look_alikes("lab"), 0.01);
  EXPECT_LT(wrong_after_look_alikes("home"), 0.03);
}

TEST(BenchKidnaps, RefusesWhatMakesNoSense) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(castaway(folder, "bench kidnaps --kidnaps 0").exit_code, 2);
  EXPECT_EQ(castaway(folder, "bench kidnaps --window 0").exit_code, 2);
  const Outcome outcome = castaway(folder, "bench kidnaps --world nowhere");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "nowhere");
}

}  // namespace
}  // namespace castaway::test
