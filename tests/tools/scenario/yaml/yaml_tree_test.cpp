#include "tools/scenario/yaml/yaml_tree.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(YamlTree, RemembersLines) {
  const YamlNode root = parse_yaml("a: 1\nb:\n  - x\n  - {c: 2}\n", "f.yaml");
  EXPECT_EQ(root.find("a")->where, "f.yaml:1");
  EXPECT_EQ(root.find("b")->where, "f.yaml:2");
  EXPECT_EQ(root.find("b")->items.back().find("c")->where, "f.yaml:4");
}

TEST(YamlTree, NamesTheLineOfBrokenText) {
  EXPECT_TRUE(contains(error_of([] { parse_yaml("a: 1\nb: [1, 2\nc: 3\n", "f.yaml"); }),
                       "f.yaml:3: not valid YAML"));
  EXPECT_TRUE(contains(error_of([] { parse_yaml("a: 1\na: 2\n", "f.yaml"); }),
                       "f.yaml:2: key 'a' appears twice"));
}

TEST(YamlTree, RefusesAliasesThatExplode) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k) text += (k > 0 ? ", " : "") + last;
    text += "]\n";
  }
  EXPECT_TRUE(contains(error_of([&] { parse_yaml(text, "f.yaml"); }), "too large"));
}

TEST(YamlTree, IsEmittedAsItWasRead) {
  const std::string text =
      "name: lab\npose: [0, -1.5, 3e-05]\nempty: {}\nnone: []\nnothing: ~\n"
      "list:\n  - mh_amcl\n  -\n    amcl:\n      preset: \"a: b # \\\"c\\\"\"\n";
  EXPECT_EQ(emit_yaml(parse_yaml(text, "f")), text);
}

TEST(YamlOverride, ReachesMapsAndLists) {
  YamlNode root = parse_yaml("seed: 1\nevents:\n  - kidnap: {at_s: 10}\n", "f");
  apply_override(root, "seed=2");
  apply_override(root, "events.0.kidnap.at_s=30.5");
  apply_override(root, "events.1={fault: {at_s: 3}}");
  apply_override(root, "lidar.profile=lds-01");
  EXPECT_EQ(emit_yaml(root),
            "seed: 2\nevents:\n  -\n    kidnap:\n      at_s: 30.5\n  -\n    fault:\n      at_s: 3\n"
            "lidar:\n  profile: lds-01\n");
  EXPECT_EQ(root.find("seed")->where, "--set seed=2");
}

TEST(YamlOverride, BeginsAListAtIndexNought) {
  YamlNode root = parse_yaml("seed: 1\n", "f");
  apply_override(root, "events.0.kidnap.at_s=3");
  EXPECT_EQ(emit_yaml(root), "seed: 1\nevents:\n  -\n    kidnap:\n      at_s: 3\n");
}

TEST(YamlOverride, PutsValuesWithAPlaceOfTheirOwn) {
  YamlNode root = parse_yaml("seed: 1\n", "f");
  put_value(root, "people.count", yaml_scalar("3"), "spec.yaml:7");
  EXPECT_EQ(emit_yaml(root), "seed: 1\npeople:\n  count: 3\n");
  EXPECT_EQ(root.find("people")->find("count")->where, "spec.yaml:7");
}

TEST(YamlOverride, GivesANameSettingsAndReplacesAText) {
  YamlNode root = parse_yaml("start: unknown\nlocalizers: [mh_amcl, amcl]\n", "f");
  apply_override(root, "start.pose=[1, 2, 3]");
  apply_override(root, "localizers.1.amcl.preset=fast");
  EXPECT_EQ(emit_yaml(root),
            "start:\n  pose: [1, 2, 3]\nlocalizers:\n  - mh_amcl\n  -\n    amcl:\n      preset: "
            "fast\n");
}

TEST(YamlOverride, TellsWhatDoesNotFit) {
  YamlNode root = parse_yaml("events: [a]\n", "f");
  EXPECT_TRUE(contains(error_of([&] { apply_override(root, "seed"); }), "key=value"));
  EXPECT_TRUE(contains(error_of([&] { apply_override(root, "a..b=1"); }), "empty key"));
  EXPECT_TRUE(contains(error_of([&] { apply_override(root, "events.7=1"); }),
                       "--set events.7=1: '7' is no index of a list of 1"));
  EXPECT_TRUE(contains(error_of([&] { apply_override(root, "a=[1"); }), "--set a=[1"));
}

TEST(YamlTree, NamesTheLineThatIsNotUtf8) {
  EXPECT_TRUE(contains(error_of([] { parse_yaml("a: 1\nname: caf\xe9\n", "f.yaml"); }),
                       "f.yaml:2: byte 0xe9 is no text in UTF-8; save the file as UTF-8"));
  EXPECT_EQ(parse_yaml("name: caf\xc3\xa9\n", "f.yaml").find("name")->scalar, "caf\xc3\xa9");
  const std::string utf16(
      "\xff\xfe"
      "a\0:\0 \0"
      "1\0",
      10);
  EXPECT_EQ(parse_yaml(utf16, "f.yaml").find("a")->scalar, "1");
}

}  // namespace
}  // namespace castaway::testbed
