#include "tools/scenario/dataset_sample.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

DatasetSpec spec_of(const std::string& vary, const std::string& more = "") {
  const TemporaryFolder folder;
  return load_dataset_spec(folder.put(
      "s.yaml", "name: set\nscenario: {world: lab, duration_s: 5}\nvary:\n" + vary + more));
}

TEST(DatasetSample, PutsDrawnValuesIntoTheScenario) {
  const DatasetSpec spec = spec_of("  people.count: {integer: [3, 4]}\n  lidar.rate_hz: 5\n");
  const SampledSequence sequence = sample_sequence(spec, 12);
  const Scenario& scenario = sequence.loaded.scenario;
  EXPECT_EQ(scenario.name, "set-000012");
  EXPECT_EQ(scenario.seed, sequence.seed);
  EXPECT_EQ(scenario.lidars.front().changes.find("rate_hz")->scalar, "5");
  EXPECT_TRUE(scenario.people.config.count() == 3 || scenario.people.config.count() == 4);
  ASSERT_EQ(sequence.drawn.size(), 2U);
  EXPECT_EQ(sequence.drawn[0].first, "people.count");
  EXPECT_EQ(sequence.drawn[0].second, std::to_string(scenario.people.config.count()));
  EXPECT_FALSE(scenario.outputs.report);
  EXPECT_TRUE(scenario.outputs.tables_hdf5);
  EXPECT_TRUE(scenario.localizers.empty());
}

TEST(DatasetSample, OneMoreKeyChangesNoOtherDraw) {
  const std::string speed = "  drive.max_speed: {uniform: [0.2, 0.6]}\n";
  const DatasetSpec one = spec_of(speed);
  const DatasetSpec two = spec_of("  people.count: {integer: [0, 99]}\n" + speed);
  for (const int index : {0, 1, 41}) {
    const SampledSequence a = sample_sequence(one, index);
    const SampledSequence b = sample_sequence(two, index);
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.drawn[0], b.drawn[1]);
  }
  EXPECT_NE(sample_sequence(one, 0).drawn[0], sample_sequence(one, 1).drawn[0]);
  EXPECT_NE(sample_sequence(one, 0).seed, sample_sequence(one, 1).seed);
  EXPECT_LT(sample_sequence(one, 0).seed, std::uint64_t{1} << 53U);
}

TEST(DatasetSample, SaysWhichSequenceKeyAndValueCannotBe) {
  const std::string wrong_type =
      error_of([] { sample_sequence(spec_of("  people.count: {choice: [many]}\n"), 3); });
  EXPECT_TRUE(contains(wrong_type,
                       "s.yaml:4: sequence 3: people.count = many: people.count: "
                       "expected a whole number, found 'many'"));
  const std::string out_of_range =
      error_of([] { sample_sequence(spec_of("  duration_s: {uniform: [-2, -1]}\n"), 0); });
  EXPECT_TRUE(contains(out_of_range, "sequence 0: "));
  EXPECT_TRUE(contains(out_of_range, "duration_s: -1."));
  EXPECT_TRUE(contains(out_of_range, "is out of range; give from 0.001"));
  const std::string unknown = error_of([] { sample_sequence(spec_of("  people.cuont: 3\n"), 5); });
  EXPECT_TRUE(contains(unknown, "sequence 5: people.cuont = 3: unknown key 'cuont'"));
  EXPECT_TRUE(contains(unknown, "did you mean 'count'?"));
}

TEST(DatasetSample, ReachesEventsByTheirIndex) {
  const DatasetSpec spec = spec_of("  events.0.kidnap.at_s: {uniform: [1, 2]}\n");
  EXPECT_EQ(sample_sequence(spec, 0).loaded.scenario.events.simulated.kidnaps.size(), 1U);
}

}  // namespace
}  // namespace castaway::testbed
