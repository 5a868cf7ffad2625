#include "tools/scenario/localizers/foreign_yaml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

LocalizerSpec read_one(const std::string& text, FilePrograms programs = FilePrograms::kAllowed) {
  YamlDocument document = YamlDocument::parse("localizers:\n  - " + text + "\n", "s.yaml");
  YamlReader root = document.root();
  auto specs = read_localizers(root, "localizers", {"/scenarios", programs});
  document.reject_unknown_keys();
  return specs.at(0);
}

std::string trouble(const std::string& text) {
  return error_of([&] { (void)read_one(text); });
}

TEST(SplitWords, KnowsQuotesAndBackslashes) {
  EXPECT_THAT(split_words("python3  mine.py -n 5"), ElementsAre("python3", "mine.py", "-n", "5"));
  EXPECT_THAT(split_words("'a b' \"c 'd'\" e\\ f g'h'i ''"),
              ElementsAre("a b", "c 'd'", "e f", "ghi", ""));
  EXPECT_TRUE(split_words("  ").empty());
  EXPECT_THROW((void)split_words("'a"), std::invalid_argument);
}

TEST(ForeignSpec, IsReadFromAScenario) {
  const LocalizerSpec spec = read_one(
      "{name: mine, program: [python3, mine.py], params: {n: 5, x: 0.5, t: a, b: true, l: [1, ~]}, "
      "timeout_s: 2, global_localization_at_kidnap: true}");
  EXPECT_EQ(spec.name, "mine");
  EXPECT_TRUE(spec.relocalize_at_kidnap);
  const auto& config = std::get<ProgramConfig>(spec.config);
  EXPECT_THAT(config.command, ElementsAre("python3", "mine.py"));
  EXPECT_EQ(config.params, R"({"n":5,"x":0.5,"t":"a","b":true,"l":[1,null]})");
  EXPECT_EQ(config.timeout_s, 2.0);
  EXPECT_EQ(config.folder, "/scenarios");
  const LocalizerSpec library = read_one("library: ./libmine.so");
  EXPECT_EQ(library.name, "mine");
  EXPECT_EQ(std::get<LibraryConfig>(library.config).params, "{}");
}

TEST(ForeignSpec, IsNamedAfterItsFile) {
  EXPECT_EQ(parse_localizer("program:python3 -u a/mine.py --map map.yaml").name, "mine");
  EXPECT_EQ(parse_localizer("program:/opt/bin/finder --map map.yaml").name, "finder");
  EXPECT_EQ(parse_localizer("library:/opt/libfinder.so").name, "finder");
  EXPECT_EQ(parse_localizer("library:plugin.so").name, "plugin");
}

TEST(ForeignSpec, SaysWhatIsWrong) {
  EXPECT_THAT(trouble("{program: []}"),
              HasSubstr("s.yaml:2: localizers[0].program: needs a program"));
  EXPECT_THAT(trouble("{program: \"a 'b\"}"), HasSubstr("a quote has no end"));
  EXPECT_THAT(trouble("{program: a, library: b}"), HasSubstr("not both"));
  EXPECT_THAT(trouble("{program: a, params: 5}"), HasSubstr("must be a map"));
  EXPECT_THAT(trouble("{program: a, timeout_s: 0}"), HasSubstr("timeout_s"));
  EXPECT_THAT(trouble("{program: a, timeot_s: 1}"), HasSubstr("timeout_s"));
  EXPECT_THAT(trouble("{program: a, name: truth}"), HasSubstr("truth.tum is taken"));
}

TEST(ForeignSpec, NeedsTrustInAFile) {
  for (const char* text : {"{program: a}", "{library: a}"}) {
    EXPECT_THAT(error_of([&] { (void)read_one(text, FilePrograms::kRefused); }),
                HasSubstr("--allow-programs"));
  }
  YamlDocument document = YamlDocument::parse("localizers: [amcl]\n", "s.yaml");
  document.set("localizers=[{program: a}]");
  YamlReader root = document.root();
  EXPECT_EQ(read_localizers(root, "localizers").at(0).name, "a");
}

/// A file cannot pass for the command line by what it calls itself.
TEST(ForeignSpec, AFileIsNoCommandLine) {
  YamlDocument document =
      YamlDocument::parse("localizers: [{program: a}]\n", "--set localizers=x.yaml");
  YamlReader root = document.root();
  EXPECT_THROW((void)read_localizers(root, "localizers"), std::runtime_error);
}

TEST(ForeignSpec, GoesIntoAScenarioAndBack) {
  const LocalizerSpec spec = parse_localizer("program:sh -c 'a \"b\"'");
  const LocalizerSpec back = read_one(foreign_yaml(spec));
  EXPECT_EQ(std::get<ProgramConfig>(back.config).command,
            std::get<ProgramConfig>(spec.config).command);
}

}  // namespace
}  // namespace castaway::testbed
