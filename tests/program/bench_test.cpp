// Short tests of castaway bench.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

TEST(BenchLocalization, PrintsTimesBesideTheReference) {
  const fs::path folder = fresh_folder();
  const Outcome words = castaway(folder, "bench localization --quick");
  ASSERT_EQ(words.exit_code, 0) << words.err;
  expect_contains(words.out, "whole update");
  expect_contains(words.out, "20 x 15 m");
  const Outcome json = castaway(folder, "bench localization --quick --json");
  ASSERT_EQ(json.exit_code, 0) << json.err;
  const auto root = nlohmann::json::parse(json.out);
  EXPECT_EQ(root.at("steps").size(), 6U);
  EXPECT_EQ(root.at("match").size(), 2U);
  EXPECT_GT(root.at("/steps/5/ratio"_json_pointer), 1.0);
}

TEST(Bench, RefusesWhatItDoesNotKnow) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(castaway(folder, "bench").exit_code, 2);
  EXPECT_EQ(castaway(folder, "bench nothing").exit_code, 2);
}

}  // namespace
}  // namespace castaway::test
