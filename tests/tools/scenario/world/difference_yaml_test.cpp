#include "tools/scenario/world/difference_yaml.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

using Kind = sim::Change::Kind;

sim::DifferenceSpec differences_of(const std::string& text) {
  YamlDocument document = YamlDocument::parse(text, "w.yaml");
  YamlReader root = document.root();
  const sim::DifferenceSpec spec = read_differences(root, ".");
  document.reject_unknown_keys();
  return spec;
}

TEST(DifferenceSpec, IsEmptyWithoutTheKey) { EXPECT_TRUE(differences_of("{}").empty()); }

TEST(DifferenceSpec, ReadsSharesAndBoxes) {
  const sim::DifferenceSpec spec = differences_of(
      "differences: {move_furniture: 0.3, reach_m: 1, remove: 0.1, close_doors: 0.5, open_doors: "
      "0.2, add_boxes: 4, seed: 9}");
  EXPECT_EQ(spec.move_furniture, 0.3);
  EXPECT_EQ(spec.reach_m, 1.0);
  EXPECT_EQ(spec.remove, 0.1);
  EXPECT_EQ(spec.close_doors, 0.5);
  EXPECT_EQ(spec.open_doors, 0.2);
  EXPECT_EQ(spec.add_boxes, 4);
  EXPECT_EQ(spec.seed, 9U);
  EXPECT_FALSE(spec.empty());
}

TEST(DifferenceSpec, ReadsChangesInOrder) {
  const sim::DifferenceSpec spec = differences_of(
      "differences:\n  changes:\n    - move: {name: a, by: [1, 2], turn_deg: 30}\n"
      "    - remove: {name: b}\n    - open: {name: c, open_deg: 40}\n    - close: {name: d}\n"
      "    - add: {box: {at: [1, 2], size: [1, 1, 1]}}\n");
  ASSERT_EQ(spec.changes.size(), 5U);
  EXPECT_EQ(spec.changes[0].by, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(spec.changes[0].turn_deg, 30.0);
  EXPECT_EQ(spec.changes[1].kind, Kind::kRemove);
  EXPECT_EQ(spec.changes[1].name, "b");
  EXPECT_EQ(spec.changes[2].kind, Kind::kOpen);
  EXPECT_EQ(spec.changes[2].open_deg, 40.0);
  EXPECT_EQ(spec.changes[3].kind, Kind::kClose);
  ASSERT_EQ(spec.changes[4].objects.size(), 1U);
}

TEST(DifferenceSpec, NamesLineAndRemedy) {
  const auto error = [](const std::string& text) {
    return error_of([&] { differences_of(text); });
  };
  EXPECT_TRUE(contains(error("differences: {remove: 2}"), "w.yaml:1"));
  EXPECT_TRUE(contains(error("differences: {remove: 2}"), "0 to 1"));
  EXPECT_TRUE(contains(error("differences: {reach_m: 0}"), "above 0"));
  EXPECT_TRUE(contains(error("differences: {add_boxes: -1}"), "0 to 1000"));
  EXPECT_TRUE(contains(error("differences: {changes: [{shift: {name: a}}]}"), "'shift'"));
  EXPECT_TRUE(contains(error("differences: {changes: [{move: {}}]}"), "'name'"));
}

}  // namespace
}  // namespace castaway::testbed
