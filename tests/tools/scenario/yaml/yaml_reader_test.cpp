#include "tools/scenario/yaml/yaml_reader.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

YamlDocument document(const std::string& text) { return YamlDocument::parse(text, "f.yaml"); }

TEST(YamlReader, ReadsTypes) {
  YamlDocument doc = document(
      "b: true\ni: -3\nu: 18446744073709551615\nd: 1.5e3\ns: text\nl: [1, 2.5]\nn: [a, b]\n"
      "v: [1, 2]\nw: [1, 2, 3]\n");
  YamlReader root = doc.root();
  EXPECT_EQ(root.get("b", false), true);
  EXPECT_EQ(root.get("i", 0), -3);
  EXPECT_EQ(root.get("u", std::uint64_t{0}), 18446744073709551615ULL);
  EXPECT_EQ(root.get("d", 0.0), 1500.0);
  EXPECT_EQ(root.get("s", ""), "text");
  EXPECT_EQ(root.require<std::vector<double>>("l"), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(root.require<std::vector<std::string>>("n"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(root.require<Eigen::Vector2d>("v"), Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(root.require<Eigen::Vector3d>("w"), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_NO_THROW(doc.reject_unknown_keys());
}

TEST(YamlReader, NamesFileLineKeyAndValueOfAWrongType) {
  YamlDocument doc = document("a: 1\nlidar:\n  rate_hz: fast\n  on: 1\n  pose: [1, 2]\n  n: 1.5\n");
  YamlReader lidar = doc.root().child("lidar");
  EXPECT_EQ(error_of([&] { (void)lidar.get("rate_hz", 1.0); }),
            "f.yaml:3: lidar.rate_hz: expected a number, found 'fast'");
  EXPECT_EQ(error_of([&] { (void)lidar.get("on", true); }),
            "f.yaml:4: lidar.on: expected true or false, found '1'");
  EXPECT_EQ(error_of([&] { (void)lidar.require<Eigen::Vector3d>("pose"); }),
            "f.yaml:5: lidar.pose: expected a list of 3 numbers, found 2 of them");
  EXPECT_EQ(error_of([&] { (void)lidar.get("n", 1); }),
            "f.yaml:6: lidar.n: expected a whole number, found '1.5'");
  EXPECT_EQ(error_of([&] { (void)doc.root().child("a"); }),
            "f.yaml:1: a: expected a map of keys and values");
}

TEST(YamlReader, RefusesInfinityAndNegativeCounts) {
  YamlDocument doc = document("a: inf\nb: nan\nc: -1\n");
  YamlReader root = doc.root();
  EXPECT_TRUE(contains(error_of([&] { (void)root.get("a", 1.0); }), "finite"));
  EXPECT_TRUE(contains(error_of([&] { (void)root.get("b", 1.0); }), "finite"));
  EXPECT_TRUE(contains(error_of([&] { (void)root.get("c", std::uint64_t{1}); }), "from 0"));
}

TEST(YamlReader, NamesAnUnknownKeyAndTheNearestKnownOne) {
  YamlDocument doc = document("seed: 1\nlidar:\n  profil: lds-01\n");
  YamlReader root = doc.root();
  (void)root.get("seed", std::uint64_t{1});
  YamlReader lidar = root.child("lidar");
  (void)lidar.get("rate_hz", 10.0);
  (void)lidar.get("profile", "ideal");
  EXPECT_EQ(error_of([&] { doc.reject_unknown_keys(); }),
            "f.yaml:3: unknown key 'profil'; did you mean 'profile'?");
}

TEST(YamlReader, NamesAnUnknownKeyOfTheCommandLine) {
  YamlDocument doc = document("seed: 1\n");
  doc.set("sed=3");
  (void)doc.root().get("seed", 1);
  EXPECT_EQ(error_of([&] { doc.reject_unknown_keys(); }),
            "--set sed=3: unknown key 'sed'; did you mean 'seed'?");
}

TEST(YamlReader, NamesAMissingKeyAndWhatMayBeMeant) {
  YamlDocument doc = document("imge: a.pgm\n");
  EXPECT_EQ(error_of([&] { (void)doc.root().require<std::string>("image"); }),
            "f.yaml:1: needs the key 'image'; is 'imge' meant to be it?");
}

TEST(YamlReader, ChecksChoices) {
  YamlDocument doc = document("by: trut\n");
  EXPECT_EQ(error_of([&] {
              (void)doc.root().choice("by", "truth", {"truth", "nobody"});
            }),
            "f.yaml:1: by: 'trut' is not allowed here; did you mean 'truth'?");
}

TEST(YamlReader, ReadsNamesWithAndWithoutSettings) {
  YamlDocument doc = document("localizers:\n  - mh_amcl\n  - amcl: {preset: x}\n");
  std::vector<std::string> names;
  for (YamlReader entry : doc.root().list("localizers")) {
    auto [name, body] = entry.name_and_body();
    names.push_back(name + "/" + body.get("preset", "default"));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"mh_amcl/default", "amcl/x"}));
  EXPECT_NO_THROW(doc.reject_unknown_keys());
}

TEST(YamlReader, EmitsTheEffectiveDocument) {
  YamlDocument doc = document("seed: 7\nlocalizers: [mh_amcl]\n");
  const auto read = [](YamlDocument& from) {
    YamlReader root = from.root();
    (void)root.get("seed", 1);
    (void)root.child("lidar").get("rate_hz", 0.1);
    for (YamlReader entry : root.list("localizers"))
      (void)entry.name_and_body().second.get("quick", true);
    (void)root.find("optional");
    from.reject_unknown_keys();
  };
  read(doc);
  const std::string effective = doc.effective();
  EXPECT_EQ(effective,
            "seed: 7\nlocalizers:\n  -\n    mh_amcl:\n      quick: true\nlidar:\n  rate_hz: 0.1\n");
  YamlDocument again = document(effective);
  read(again);
  EXPECT_EQ(again.effective(), effective);
}

TEST(YamlReader, TakesNothingForNotThere) {
  YamlDocument doc = document("a: ~\nb:\n");
  YamlReader root = doc.root();
  EXPECT_FALSE(root.has("a"));
  EXPECT_EQ(root.get("a", 3), 3);
  EXPECT_TRUE(root.list("b").empty());
  EXPECT_EQ(root.get_optional<int>("c"), std::nullopt);
}

TEST(YamlReader, NamesAFileThatIsNotThere) {
  EXPECT_TRUE(
      contains(error_of([] { YamlDocument::load("/no/such.yaml"); }), "/no/such.yaml: cannot"));
}

TEST(YamlReader, RawValuesKeepTheirKeysWhateverTheyAre) {
  YamlDocument document = YamlDocument::parse("free: {any: {thing: 1}}\n", "f.yaml");
  YamlNode copy = document.root().find("free")->raw();
  document.reject_unknown_keys();
  YamlDocument again(copy);
  EXPECT_TRUE(contains(error_of([&] { again.reject_unknown_keys(); }), "unknown key 'any'"));
}

}  // namespace
}  // namespace castaway::testbed
