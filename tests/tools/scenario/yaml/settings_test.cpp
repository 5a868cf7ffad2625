#include "tools/scenario/yaml/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

enum class Colour { kRed, kBlue };

struct Inner {
  double length = 2.0;
};

struct Config {
  double speed = 0.5;
  std::optional<int> layer{};
  Colour colour = Colour::kBlue;
  std::string view = "map";
  Inner inner;
};

void fields(Settings settings, Inner& inner) {
  settings.field({"length_m", "m", "How long.", {0.0, 10.0}}, inner.length);
}

void fields(Settings settings, Config& config) {
  settings.field({"speed", "m/s", "How fast.", {0.1, 1.0}}, config.speed);
  settings.optional({"layer", "", "Which."}, config.layer);
  settings.choice({"colour", "", "What colour."}, config.colour,
                  {{"red", Colour::kRed}, {"blue", Colour::kBlue}});
  settings.choice({"view", "", "From where."}, config.view, {"chase", "map"});
  settings.form({"world", "", "Where."}, "lab");
  fields(settings.group("inner"), config.inner);
}

struct Read {
  Config config;
  std::string document;
};

Read read(const std::string& text, bool fills = true) {
  YamlDocument document = YamlDocument::parse(text, "a.yaml");
  YamlReader root = document.root();
  Read result;
  fields(fills ? Settings::reading(root) : Settings::changing(root), result.config);
  document.reject_unknown_keys();
  result.document = document.effective();
  return result;
}

TEST(Settings, TakeWhatIsGivenAndWriteTheRest) {
  const Read got = read("speed: 0.7\ncolour: red\n");
  EXPECT_EQ(got.config.speed, 0.7);
  EXPECT_EQ(got.config.colour, Colour::kRed);
  EXPECT_FALSE(got.config.layer.has_value());
  EXPECT_EQ(got.document, "speed: 0.7\ncolour: red\nview: map\ninner:\n  length_m: 2\n");
  EXPECT_EQ(read(got.document).document, got.document);
}

TEST(Settings, ThatChangeWriteNothing) {
  const Read got = read("layer: 3\ninner: {length_m: 4}\n", false);
  EXPECT_EQ(got.config.layer, 3);
  EXPECT_EQ(got.config.inner.length, 4.0);
  EXPECT_EQ(got.document, "layer: 3\ninner:\n  length_m: 4\n");
  EXPECT_EQ(read("{}", false).document, "{}\n");
}

TEST(Settings, NamePlaceKeyAndRange) {
  EXPECT_EQ(error_of([] { read("inner:\n  length_m: 11\n"); }),
            "a.yaml:2: inner.length_m: 11 is out of range; give from 0 to 10 m");
  EXPECT_THAT(error_of([] { read("colour: rde\n"); }), testing::HasSubstr("'red'"));
  EXPECT_THAT(error_of([] { read("sped: 1\n"); }), testing::HasSubstr("'speed'"));
}

TEST(Settings, AreDescribedInTheOrderOfTheirTable) {
  std::vector<SettingText> texts;
  Config config;
  fields(Settings::describing(texts, "drive."), config);
  ASSERT_EQ(texts.size(), 6U);
  EXPECT_EQ(texts[0].path, "drive.speed");
  EXPECT_EQ(texts[0].value, "0.5");
  EXPECT_EQ(texts[0].range, "0.1 to 1");
  EXPECT_EQ(texts[0].unit, "m/s");
  EXPECT_EQ(texts[1].value, "");
  EXPECT_EQ(texts[2].range, "red, blue");
  EXPECT_EQ(texts[2].value, "blue");
  EXPECT_EQ(texts[5].path, "drive.inner.length_m");
}

}  // namespace
}  // namespace castaway::testbed
