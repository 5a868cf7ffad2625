// A catalogue of broken worlds, maps and SDF files: each gives one clear line and exit code 2.
#include <algorithm>
#include <functional>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// Files by name, the one to check, and the required parts of the error line.
struct BadWorld {
  const char* name;
  std::string checked;
  std::vector<std::pair<std::string, std::string>> files;
  std::vector<std::string> parts;
};

std::ostream& operator<<(std::ostream& out, const BadWorld& world) { return out << world.name; }

std::string test_name(const testing::TestParamInfo<BadWorld>& info) { return info.param.name; }

const std::string kHead = "name: w\nextent: {min: [0, 0], max: [4, 3]}\nstart: [2, 2, 0]\n";

BadWorld yaml(const char* name, const std::string& text, std::vector<std::string> parts) {
  return {name, "w.yaml", {{"w.yaml", text}}, std::move(parts)};
}

BadWorld object(const char* name, const std::string& entry, std::vector<std::string> parts) {
  parts.emplace_back("w.yaml:5");
  return yaml(name, kHead + "objects:\n  - " + entry + "\n", std::move(parts));
}

std::vector<BadWorld> object_cases() {
  return {
      object("UnknownKind", "ball: {at: [1, 1]}", {"no such kind", "sphere"}),
      object("MissingSize", "box: {at: [1, 1], sice: [1, 1, 1]}", {"'size'", "'sice'"}),
      object("NanSize", "box: {at: [1, 1], size: [.nan, 1, 1]}", {"size", "number"}),
      object("NegativeSize", "box: {at: [1, 1], size: [1, -1, 1]}", {"above 0"}),
      object("HugeSize", "box: {at: [1, 1], size: [1e9, 1, 1]}", {"1000 m"}),
      object("InfinitePlace", "box: {at: [.inf, 1], size: [1, 1, 1]}", {"at", "number"}),
      object("ThreeCoordinates", "box: {at: [1, 1, 1], size: [1, 1, 1]}", {"list of 2 numbers"}),
      object("ZeroRadius", "cylinder: {at: [1, 1], radius: 0, height: 1}", {"above 0"}),
      object("NoHeight", "cylinder: {at: [1, 1], radius: 1}", {"'height'"}),
      object("FlatTable", "table: {at: [1, 1], size: [1, 1, 0.01]}", {"0.03"}),
      object("ShelfOfNoLevels", "shelf: {at: [1, 1], size: [1, 1, 2], levels: 0}", {"1 to 20"}),
      object("ChairTooLow", "chair: {at: [1, 1], size: [0.5, 0.5, 0.4]}", {"0.45"}),
      object("WallOfOnePoint", "wall: {points: [[0, 0]]}", {"needs `points`"}),
      object("WallOnTheSpot", "wall: {points: [[0, 0], [0, 0]]}", {"same point twice"}),
      object("WindowAboveItself", "window: {from: [0, 0], to: [1, 0], sill: 3}", {"below"}),
      object("WindowOfNoLength", "window: {from: [0, 0], to: [0, 0]}", {"same point"}),
      object("DoorHingedOnTop", "door: {at: [1, 1], width: 1, hinge: top}", {"'top'", "left"}),
      object("DoorOpenTooFar", "door: {at: [1, 1], width: 1, open_deg: 270}", {"-180 to 180"}),
      object("DoorHalfOnTheMap", "door: {at: [1, 1], width: 1, in_map: half}", {"'half'"}),
      object("Mirror", "box: {at: [1, 1], size: [1, 1, 1], reflectivity: 2}", {"0 to 1"}),
      object("RedByName", "box: {at: [1, 1], size: [1, 1, 1], color: red}", {"#rrggbb"}),
      object("Nowhere", "box: {at: [1, 1], size: [1, 1, 1], in_map: false, in_world: false}",
             {"neither"}),
      object("MissingMesh", "mesh: {at: [1, 1], file: chair.obj}", {"chair.obj"}),
      object("MeshOutside", "mesh: {at: [1, 1], file: ../../../../../../etc/passwd}",
             {"leads out of the world's folder"}),
      object("AbsoluteMesh", "mesh: {at: [1, 1], file: /etc/passwd}", {"leads out"}),
      object("RepeatNothing", "repeat: {at: [0, 0], count: [2, 2]}", {"nothing to repeat"}),
      object("RepeatHalf", "repeat: {at: [0, 0], count: [1.5, 2], objects: []}", {"whole numbers"}),
      object("RepeatAMillionTimes",
             "repeat: {at: [0, 0], count: [1000, 1000], objects: [box: {at: [1, 1], size: [1, 1, "
             "1]}]}",
             {"count"}),
  };
}

std::vector<BadWorld> world_cases() {
  const std::string box = "box: {name: a, at: [1, 1], size: [0.2, 0.2, 1]}\n";
  std::string bomb = "a: &a [x, x, x, x, x, x, x, x, x]\n";
  for (char c = 'b'; c < 'k'; ++c) {
    const std::string last(1, static_cast<char>(c - 1));
    bomb += std::string(1, c) + ": &" + c + " [";
    for (int i = 0; i < 9; ++i) bomb += std::string(i > 0 ? ", *" : "*") + last;
    bomb += "]\n";
  }
  return {
      yaml("Empty", "", {"w.yaml"}),
      yaml("NoYaml", "name: [1, 2\n", {"w.yaml", "not valid YAML"}),
      yaml("AliasBomb", bomb, {"aliases"}),
      yaml("NoExtent", "name: w\n", {"'min'"}),
      yaml("ExtentInsideOut", "name: w\nextent: {min: [1, 1], max: [0, 2]}\n", {"above"}),
      yaml("ExtentOfAPlanet", "name: w\nextent: {min: [0, 0], max: [1e7, 1e7]}\n", {"1000 m"}),
      yaml("StartOutside", "name: w\nextent: {min: [0, 0], max: [1, 1]}\nstart: [5, 5, 0]\n",
           {"start", "outside"}),
      yaml("RouteOutside", kHead + "routes: {r: [[1, 1], [9, 9]]}\n", {"w.yaml:4", "outside"}),
      yaml("RouteOfOnePoint", kHead + "routes: {r: [[1, 1]]}\n", {"two points"}),
      yaml("DuplicateNames", kHead + "objects:\n  - " + box + "  - " + box, {"'a' is taken"}),
      yaml("ZoneCrossesItself",
           kHead + "slip_zones: [{outline: [[0, 0], [1, 1], [1, 0], [0, 1]]}]\n",
           {"crosses itself"}),
      yaml("ZoneOfTwoPoints", kHead + "slip_zones: [{outline: [[0, 0], [1, 1]]}]\n", {"three"}),
      yaml("ZoneOfNoArea", kHead + "slip_zones: [{outline: [[0, 0], [1, 1], [2, 2]]}]\n",
           {"w.yaml:4"}),
      yaml("SlipOfAll", kHead + "slip_zones: [{outline: [[0, 0], [1, 1], [1, 0]], slip: 1}]\n",
           {"below 1"}),
      yaml("UnknownKey", kHead + "object: []\n", {"'object'", "'objects'"}),
      yaml("ShareAboveOne", kHead + "differences: {remove: 2}\n", {"0 to 1"}),
      yaml("UnknownDifference", kHead + "differences: {shuffle: 1}\n", {"'shuffle'"}),
      yaml("DifferenceOfNobody",
           kHead + "objects:\n  - " + box + "differences: {changes: [{remove: {name: b}}]}\n",
           {"no object 'b'", "'a'"}),
      yaml("DoorThatIsNone",
           kHead + "objects:\n  - " + box + "differences: {changes: [{close: {name: a}}]}\n",
           {"no door 'a'"}),
  };
}

BadWorld map_case(const char* name, const std::string& keys, const std::string& image,
                  std::vector<std::string> parts) {
  return {name, "m.yaml", {{"m.yaml", keys}, {"m.pgm", image}}, std::move(parts)};
}

std::vector<BadWorld> map_cases() {
  const std::string good = "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n";
  const std::string pixels = "P5\n2 2\n255\nabcd";
  const std::string png = "\x89PNG\r\n\x1a\n";
  const std::string header("\0\0\0\rIHDR\x7f\xff\xff\xff\x7f\xff\xff\xff\x08\0\0\0\0", 21);
  return {
      map_case("MissingImage", "image: no.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n", pixels,
               {"no.pgm"}),
      map_case("TruncatedPgm", good, "P5\n20 20\n255\nabc", {"m.pgm", "cut short"}),
      map_case("HugePgm", good, "P5\n2000000000 2000000000\n255\nabc", {"m.pgm", "width"}),
      map_case("LargePgmOfNothing", good, "P5\n32768 32768\n255\nabc",
               {"m.pgm", "32768 x 32768 pixels"}),
      map_case("WrongMagic", good, "GIF89a...", {"m.pgm"}),
      map_case("EmptyImage", good, "", {"m.pgm"}),
      map_case("PixelAboveTheLargest", good, "P2\n1 1\n10\n99\n", {"m.pgm"}),
      map_case("HugePng", good, png + header, {"m.pgm", "PNG"}),
      map_case("TruncatedPng", good, png, {"m.pgm", "PNG"}),
      map_case("ResolutionZero", "image: m.pgm\nresolution: 0\norigin: [0, 0, 0]\n", pixels,
               {"resolution", "above 0"}),
      map_case("ResolutionNan", "image: m.pgm\nresolution: .nan\norigin: [0, 0, 0]\n", pixels,
               {"resolution"}),
      map_case("ThresholdsSwapped", good + "free_thresh: 0.8\noccupied_thresh: 0.2\n", pixels,
               {"free_thresh"}),
      {"PictureWithoutYaml", "m.png", {{"m.png", png}}, {"m.png", "m.yaml", "resolution"}},
      {"PictureBesideYaml", "m.png", {{"m.png", png}, {"m.yaml", good}}, {"give its YAML file"}},
      map_case("UnknownMode", good + "mode: binary\n", pixels, {"mode", "trinary", "binary"}),
      map_case("OriginOfTwo", "image: m.pgm\nresolution: 0.05\norigin: [0, 0]\n", pixels,
               {"origin", "3 numbers"}),
  };
}

std::string sdf(const std::string& inside) {
  return "<?xml version=\"1.0\"?>\n<sdf version=\"1.6\">\n<world name=\"w\">\n" + inside +
         "</world>\n</sdf>\n";
}

std::string model(const std::string& geometry, const std::string& pose = "1 2 0.5 0 0 0") {
  return "<model name=\"m\"><static>true</static><pose>" + pose +
         "</pose><link name=\"l\"><collision name=\"c\"><geometry>" + geometry +
         "</geometry></collision></link></model>\n";
}

BadWorld world(const char* name, const std::string& text, std::vector<std::string> parts) {
  return {name, "w.sdf", {{"w.sdf", text}}, std::move(parts)};
}

BadWorld including(const char* name, const std::string& uri, std::vector<std::string> parts) {
  return world(name, sdf("<include><uri>" + uri + "</uri></include>\n"), std::move(parts));
}

std::vector<BadWorld> sdf_cases() {
  const std::string loop =
      "<sdf version=\"1.6\"><model name=\"a\"><include><uri>model://a</uri></include>"
      "<link name=\"l\"/></model></sdf>";
  const std::string bomb =
      "<!DOCTYPE a [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n" + sdf("&b;");
  return {
      world("NotXml", "name: world\n", {"w.sdf"}),
      world("Nothing", "", {"w.sdf"}),
      world("CutShort", sdf(model("<box><size>1 1 1</size></box>")).substr(0, 200), {"w.sdf"}),
      world("NoWorld", "<sdf version=\"1.6\"></sdf>", {"w.sdf"}),
      world("EmptyWorld", sdf(""), {"w.sdf", "nothing"}),
      world("EntityBomb", bomb, {"w.sdf", "DOCTYPE"}),
      world("BoxOfTwoEdges", sdf(model("<box><size>1 1</size></box>")), {"w.sdf"}),
      world("NegativeBox", sdf(model("<box><size>1 -1 1</size></box>")), {"w.sdf"}),
      world("NanSphere", sdf(model("<sphere><radius>nan</radius></sphere>")), {"w.sdf"}),
      world("NanPose", sdf(model("<box><size>1 1 1</size></box>", "nan 0 0 0 0 0")), {"w.sdf"}),
      world("FrameOfNobody",
            sdf("<model name=\"m\"><static>true</static><pose relative_to=\"x\">0 0 0 0 0 0</pose>"
                "<link name=\"l\"/></model>"),
            {"w.sdf", "x"}),
      world("FarAway",
            sdf(model("<box><size>1 1 1</size></box>", "1e7 0 0.5 0 0 0") +
                "<model name=\"n\"><static>true</static><link name=\"l\"><collision "
                "name=\"c\"><geometry><box><size>1 1 1</size></box></geometry>"
                "</collision></link></model>"),
            {"w.sdf", "1000 m"}),
      world("MissingMeshFile", sdf(model("<mesh><uri>model://a/b.dae</uri></mesh>")),
            {"w.sdf", "model://a/b.dae", "search_paths"}),
      world("MeshOutsideOfAll", sdf(model("<mesh><uri>file:///etc/passwd</uri></mesh>")),
            {"w.sdf", "/etc/passwd"}),
      world("MeshOfNoScale", {sdf(model("<mesh><uri>a.obj</uri><scale>0 1 1</scale></mesh>"))},
            {"w.sdf", "scale"}),
      {"MeshIsNoMesh",
       "w.sdf",
       {{"w.sdf", sdf(model("<mesh><uri>a.stl</uri></mesh>"))}, {"a.stl", "solid nothing"}},
       {"a.stl"}},
      including("MissingModel", "model://nobody", {"model://nobody", "search_paths"}),
      including("ModelOnTheNet", "https://fuel.gazebosim.org/1.0/x/models/y",
                {"not on this machine"}),
      including("ModelOutside", "../../../../../../../../etc", {"outside"}),
      {"ModelWithoutFile",
       "w.sdf",
       {{"w.sdf", sdf("<include><uri>model://a</uri></include>")}, {"models/a/readme", "x"}},
       {"model.sdf"}},
      {"ModelThatIncludesItself",
       "w.sdf",
       {{"w.sdf", sdf("<include><uri>model://a</uri></include>")}, {"models/a/model.sdf", loop}},
       {"includes itself"}},
  };
}

#ifdef __SANITIZE_ADDRESS__
constexpr const char* kLimit = "";  // Sanitizers reserve terabytes.
#else
constexpr const char* kLimit = "ulimit -v 4000000;";  // [kB] Catches huge allocations.
#endif

class BadWorlds : public testing::TestWithParam<BadWorld> {};

TEST_P(BadWorlds, EndInOneLineAndCodeTwo) {
  const fs::path folder = fresh_folder();
  for (const auto& [name, text] : GetParam().files) {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
  }
  const Outcome outcome =
      castaway(folder, "check-world " + GetParam().checked + " --no-picture", kLimit);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_LT(outcome.err.size(), 1200U) << outcome.err;
  for (const std::string& part : GetParam().parts) expect_contains(outcome.err, part);
}

INSTANTIATE_TEST_SUITE_P(Objects, BadWorlds, testing::ValuesIn(object_cases()), test_name);
INSTANTIATE_TEST_SUITE_P(Worlds, BadWorlds, testing::ValuesIn(world_cases()), test_name);
INSTANTIATE_TEST_SUITE_P(Maps, BadWorlds, testing::ValuesIn(map_cases()), test_name);
INSTANTIATE_TEST_SUITE_P(Sdf, BadWorlds, testing::ValuesIn(sdf_cases()), test_name);

/// Beside a valid model, a broken one is skipped with a warning, or rejected by --strict.
TEST(PiecesOfAWorld, AreLeftOutUnlessStrict) {
  const fs::path folder = fresh_folder();
  const auto piece = [](const std::string& name, const std::string& inside) {
    return "<model name='" + name + "'><static>1</static>" + inside + "</model>\n";
  };
  const auto link = [](const std::string& geometry) {
    return "<link name='l'><collision name='c'><geometry>" + geometry +
           "</geometry></collision></link>";
  };
  const std::vector<std::string> pieces{
      "<model name='hollow'></model>",
      piece("__x__", link("<box><size>1 1 1</size></box>")),
      piece("lost", link("<mesh><uri>model://a/b.dae</uri></mesh>")),
      piece("mesh", link("<mesh><uri>a.stl</uri></mesh>")),
      piece("crooked", link("<box><size>1 1</size></box>")),
      "<include><uri>model://nobody</uri></include>",
      "<include><uri>https://fuel.gazebosim.org/1.0/x/models/y</uri></include>"};
  std::ofstream(folder / "a.stl") << "solid nothing";
  for (const std::string& bad : pieces) {
    std::ofstream(folder / "w.sdf") << sdf(model("<box><size>1 1 1</size></box>") + bad);
    const Outcome lenient = castaway(folder, "check-world w.sdf --no-picture");
    EXPECT_EQ(lenient.exit_code, 0) << bad << lenient.err;
    expect_contains(lenient.out, "warning: left out, since");
    const Outcome strict = castaway(folder, "check-world w.sdf --no-picture --strict");
    EXPECT_EQ(strict.exit_code, 2) << bad;
    expect_contains(strict.err, "w.sdf");
  }
}

TEST(PiecesOfAWorld, AreOneWarningIfTheyAreAlike) {
  const fs::path folder = fresh_folder();
  std::string models = model("<box><size>1 1 1</size></box>");
  for (int i = 0; i < 100; ++i) {
    models += "<include><uri>model://nobody" + std::to_string(i) + "</uri></include>";
  }
  std::ofstream(folder / "w.sdf") << sdf(models);
  const Outcome outcome = castaway(folder, "check-world w.sdf --no-picture");
  EXPECT_EQ(outcome.exit_code, 0);
  expect_contains(outcome.out, "model://nobody0, model://nobody1, model://nobody2 and 97 more");
}

/// Worlds that load but in which no run is possible.
TEST(RunInABadWorld, SaysWhyNot) {
  const fs::path folder = fresh_folder();
  const std::string run = "run --duration 1 --set events=[] --set outputs.snapshots=false --world ";
  std::ofstream(folder / "wall.yaml")
      << kHead << "objects: [box: {at: [2, 2], size: [0.5, 0.5, 1]}]\n";
  const Outcome wall = castaway(folder, run + "wall.yaml");
  EXPECT_EQ(wall.exit_code, 2);
  expect_contains(wall.err, "stands in an obstacle");
  std::ofstream(folder / "full.yaml")
      << kHead << "objects: [box: {at: [2, 1.5], size: [4, 3, 1]}]\n";
  const Outcome full = castaway(folder, run + "full.yaml");
  EXPECT_EQ(full.exit_code, 2);
  expect_contains(full.err, "no place");
}

/// The file is sparse and must not be read.
TEST(HugeMesh, IsRefusedBeforeItIsRead) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "big.stl") << "x";
  fs::resize_file(folder / "big.stl", 1ULL << 32U);
  std::ofstream(folder / "w.yaml") << kHead << "objects: [mesh: {at: [1, 1], file: big.stl}]\n";
  std::ofstream(folder / "w.sdf") << sdf(model("<mesh><uri>big.stl</uri></mesh>"));
  for (const char* file : {"w.yaml", "w.sdf"}) {
    const Outcome outcome = castaway(folder, std::string("check-world --no-picture ") + file);
    EXPECT_EQ(outcome.exit_code, 2);
    expect_contains(outcome.err, "4096 MiB");
  }
}

}  // namespace
}  // namespace castaway::test
