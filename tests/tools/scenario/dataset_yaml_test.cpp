#include "tools/scenario/dataset_yaml.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

const char* const kSpec = R"(name: small
license: CC0-1.0
scenario:
  world: lab
  people: {count: 2}
vary:
  people.count: {integer: [0, 9]}
  duration_s: 5
)";

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  return error_of([&] { load_dataset_spec(folder.put("s.yaml", text)); });
}

TEST(DatasetSpec, HasABagTablesAndNoLocalizersUnlessToldOtherwise) {
  const TemporaryFolder folder;
  const DatasetSpec spec = load_dataset_spec(folder.put("s.yaml", kSpec));
  EXPECT_EQ(spec.name, "small");
  EXPECT_EQ(spec.license, "CC0-1.0");
  EXPECT_EQ(spec.seed, 1U);
  EXPECT_EQ(spec.base, folder.path());
  ASSERT_EQ(spec.vary.size(), 2U);
  EXPECT_EQ(spec.vary[0].path, "people.count");
  EXPECT_EQ(spec.scenario.find("localizers")->items.size(), 0U);
  EXPECT_EQ(spec.scenario.find("outputs")->find("report")->scalar, "false");
  EXPECT_EQ(spec.scenario.find("outputs")->find("tables")->scalar, "hdf5");
  EXPECT_EQ(spec.scenario.find("outputs")->find("bag")->scalar, "true");
}

TEST(DatasetSpec, ItsEffectiveTextStandsForIt) {
  const TemporaryFolder folder;
  folder.put("runs/base.yaml",
             "world: lab\nseed: 9\nlocalizers: [amcl]\nexpect: {collisions: \"== 0\"}\n");
  const auto file = folder.put("s.yaml", "scenario: runs/base.yaml\noutputs: {tables: csv}\n");
  const DatasetSpec spec = load_dataset_spec(file, {7, {"duration_s=3"}});
  EXPECT_EQ(spec.seed, 7U);
  EXPECT_EQ(spec.base, folder.path() / "runs");
  const DatasetSpec again = load_dataset_spec(folder.put("dataset.yaml", spec.effective));
  EXPECT_EQ(again.effective, spec.effective);
  EXPECT_EQ(again.name, "s");
  EXPECT_EQ(again.seed, 7U);
  EXPECT_EQ(emit_yaml(again.scenario), emit_yaml(spec.scenario));
  EXPECT_EQ(again.scenario.find("duration_s")->scalar, "3");
  EXPECT_EQ(again.scenario.find("expect"), nullptr);
  EXPECT_EQ(again.scenario.find("seed"), nullptr);
}

TEST(DatasetSpec, TakesTheNameOfAShippedScenario) {
  const TemporaryFolder folder;
  const DatasetSpec spec = load_dataset_spec(folder.put("s.yaml", "scenario: office/people\n"));
  EXPECT_EQ(spec.scenario.find("world")->scalar, "office");
}

TEST(DatasetSpec, RefusesWhatItDoesNotKnow) {
  EXPECT_TRUE(contains(refusal("scenari: lab/kidnap\n"),
                       "s.yaml:1: unknown key 'scenari'; did you mean 'scenario'?"));
  EXPECT_TRUE(contains(refusal("scenario: nowhere/none\n"),
                       "s.yaml:1: scenario: nowhere/none: no such scenario"));
  EXPECT_TRUE(contains(refusal("vary: {seed: 3}\n"), "'seed' cannot vary"));
  EXPECT_TRUE(contains(refusal("vary:\n  outputs.bag: true\n"), "'outputs' cannot vary"));
  EXPECT_TRUE(contains(refusal("splits: {train: -1}\n"), "none negative"));
  EXPECT_TRUE(contains(refusal("splits: {by: frame}\n"), "'frame' is not allowed here"));
  EXPECT_TRUE(contains(refusal("outputs: bag\n"), "expected a map"));
}

}  // namespace
}  // namespace castaway::testbed
