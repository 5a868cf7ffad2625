// Tests of the allowed include directions between the parts of the project.
// Over 400 lines: half of it is the table of rooms, which belongs together.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// The folders of the product's sources.
constexpr std::array kParts = {"localization", "xacro",  "sim",   "tools",
                               "include",      "public", "python"};

/// An include directive: the including file and the included header.
struct Include {
  std::string file;    ///< Relative to the root of the project.
  std::string header;  ///< Between the quotes or brackets.
};

bool starts_with(const std::string& text, const std::string& prefix) {
  return text.rfind(prefix, 0) == 0;
}

std::vector<Include> all_includes() {
  static const std::regex line_of(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  const fs::path root = CASTAWAY_SOURCE_DIR;
  std::vector<Include> includes;
  for (const char* part : kParts) {
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".hpp" && extension != ".cpp") continue;
      std::ifstream stream(entry.path());
      std::smatch match;
      for (std::string line; std::getline(stream, line);) {
        if (!std::regex_search(line, match, line_of)) continue;
        includes.push_back({fs::relative(entry.path(), root).generic_string(), match[1]});
      }
    }
  }
  return includes;
}

/// All includes of headers accepted by `header` in files rejected by `file_may`, as "file ->
/// header".
std::vector<std::string> violations(const std::function<bool(const std::string&)>& header,
                                    const std::function<bool(const std::string&)>& file_may) {
  static const std::vector<Include> includes = all_includes();
  std::vector<std::string> found;
  for (const Include& include : includes) {
    if (header(include.header) && !file_may(include.file)) {
      found.push_back(include.file + " -> " + include.header);
    }
  }
  return found;
}

using Names = std::vector<std::string>;

TEST(Includes, AreFound) {
  const Names everything =
      violations([](const auto&) { return true; }, [](const auto&) { return false; });
  EXPECT_GT(everything.size(), 300U);
}

/// Public headers whose structs and whose interface the localizers themselves use.
bool is_shared_with_localization(const std::string& header) {
  const Names shared = {"castaway/grid.hpp", "castaway/localizer.hpp", "castaway/pose.hpp",
                        "castaway/readings.hpp", "castaway/stamp.hpp"};
  return std::find(shared.begin(), shared.end(), header) != shared.end();
}

TEST(Includes, PublicHeadersKnowEigenTheStandardLibraryAndEachOtherOnly) {
  const std::regex standard(R"re(std(def|int)\.h|[a-z0-9_]+)re");
  EXPECT_EQ(violations(
                [&](const std::string& h) {
                  return !std::regex_match(h, standard) && !starts_with(h, "Eigen/") &&
                         !starts_with(h, "castaway/");
                },
                [](const std::string& f) { return !starts_with(f, "include/"); }),
            Names{});
}

/// What is inside knows the structs that it shares with them, and nothing that is built on it.
TEST(Includes, OfPublicHeadersTheInsideKnowsTheSharedOnesOnly) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return starts_with(h, "castaway/") && !is_shared_with_localization(h) &&
                         h != "castaway/frame.hpp" && h != "castaway/localizer.h";
                },
                [](const std::string& f) {
                  return starts_with(f, "include/") || starts_with(f, "public/") ||
                         starts_with(f, "python/");
                }),
            Names{});
}

TEST(Includes, SourcesOfThePublicHeadersAreKnownToPythonOnly) {
  EXPECT_EQ(violations([](const std::string& h) { return starts_with(h, "public/"); },
                       [](const std::string& f) {
                         return starts_with(f, "public/") || starts_with(f, "python/");
                       }),
            Names{});
}

/// A robot's program needs neither the simulator nor the other floors for its localizer.
TEST(Includes, LocalizersByThemselvesKnowNothingOfTheSimulator) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return starts_with(h, "tools/") && !starts_with(h, "tools/scenario/yaml/") &&
                         !starts_with(h, "tools/scenario/localizers/");
                },
                [](const std::string& f) {
                  return f.find("amcl.cpp") == std::string::npos || !starts_with(f, "public/");
                }),
            Names{});
}

TEST(Includes, LocalizationKnowsNothingButEigenBoostAndTheStandardLibrary) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return h.find('.') != std::string::npos && !starts_with(h, "localization/") &&
                         !starts_with(h, "boost/random/") && !is_shared_with_localization(h);
                },
                [](const std::string& f) { return !starts_with(f, "localization/"); }),
            Names{});
}

TEST(Includes, XacroKnowsNoOtherLibraryOfOurs) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return h.find('/') != std::string::npos && !starts_with(h, "xacro/") &&
                         !starts_with(h, "fmt/");
                },
                [](const std::string& f) { return !starts_with(f, "xacro/"); }),
            Names{});
}

TEST(Includes, SimKnowsNeitherLocalizationNorTools) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return starts_with(h, "localization/") || starts_with(h, "tools/") ||
                         starts_with(h, "castaway/") || starts_with(h, "yaml-cpp/");
                },
                [](const std::string& f) { return !starts_with(f, "sim/"); }),
            Names{});
}

TEST(Includes, BulletAppearsInItsFoldersOnly) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return starts_with(h, "bt") || starts_with(h, "Bullet") ||
                         starts_with(h, "LinearMath");
                },
                [](const std::string& f) {
                  return starts_with(f, "sim/world/") || starts_with(f, "sim/robot/") ||
                         starts_with(f, "sim/people/");
                }),
            Names{});
}

TEST(Includes, GlAppearsInRenderOnly) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return starts_with(h, "epoxy/") || starts_with(h, "GL/") ||
                         starts_with(h, "EGL/");
                },
                [](const std::string& f) { return starts_with(f, "sim/render/"); }),
            Names{});
}

TEST(Includes, YamlAppearsInScenarioOnly) {
  EXPECT_EQ(violations([](const std::string& h) { return starts_with(h, "yaml-cpp/"); },
                       [](const std::string& f) { return starts_with(f, "tools/scenario/"); }),
            Names{});
}

TEST(Includes, DdsAppearsInItsFolderOnly) {
  EXPECT_EQ(violations([](const std::string& h) { return starts_with(h, "dds/"); },
                       [](const std::string& f) { return starts_with(f, "tools/ros/dds/"); }),
            Names{});
}

TEST(Includes, PythonAppearsInItsFolderOnly) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return starts_with(h, "pybind11/") || starts_with(h, "python/") ||
                         h == "Python.h";
                },
                [](const std::string& f) { return starts_with(f, "python/"); }),
            Names{});
}

TEST(Includes, TheLowestFloorsLinkWithoutTheSimulator) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return starts_with(h, "sim/") && !starts_with(h, "sim/record/") &&
                         !starts_with(h, "sim/scene/") && !starts_with(h, "sim/render/");
                },
                [](const std::string& f) {
                  const Names bound = {"tools/base/", "tools/run/", "tools/ros/", "tools/outputs/",
                                       "tools/pages/"};
                  return std::none_of(bound.begin(), bound.end(),
                                      [&](const auto& room) { return starts_with(f, room); });
                }),
            Names{});
}

/// Folders from the lowest layer up; a folder may include itself and folders of lower layers only.
using Layers = std::vector<Names>;

const Layers kSimLayers = {
    {"sim/common", "sim/record", "sim/scene"},
    {"sim/people/forces", "sim/world/bullet"},
    {"sim/render", "sim/world"},
    {"sim/casting", "sim/robot/urdf", "sim/world/sdf"},
    {"sim/map", "sim/robot/discovery", "sim/sensor"},
    {"sim/people/bodies"},
    {"sim/difference", "sim/events"},
    {"sim/people", "sim/robot/bodies"},
    {"sim/navigation", "sim/robot"},
    {"sim/stages"},
    {"sim"},
};

/// Floors of the program from the ground up, and their rooms from the lowest layer up.
const Layers kToolsLayers = {
    // 1. base
    {"tools/base/files"},
    {"tools/base/bytes", "tools/base/formats/images", "tools/base/formats/points"},
    {"tools/base/formats", "tools/base/formats/volume"},
    {"tools/base/output"},
    {"tools/base/process"},
    // 2. run
    {"tools/run", "tools/run/metrics/statistics"},
    {"tools/run/metrics"},
    // 3. ros
    {"tools/ros/dds", "tools/ros/storage"},
    {"tools/ros"},
    {"tools/ros/clouds"},
    // 4. outputs
    {"tools/outputs/records"},
    {"tools/outputs/pictures", "tools/outputs/sinks"},
    // 5. scenario
    {"tools/scenario/yaml"},
    {"tools/scenario/files"},
    {"tools/scenario/sections"},
    {"tools/scenario/localizers", "tools/scenario/world"},
    {"tools/scenario"},
    // 6. build
    {"tools/build/foreign", "tools/build/map3d", "tools/build/recorded", "tools/build/scene"},
    {"tools/build/bag", "tools/build/ros2"},
    {"tools/build"},
    // 7. play
    {"tools/play/inspect", "tools/play/observation"},
    {"tools/play"},
    {"tools/play/replay"},
    // 8. batch
    {"tools/batch/jobs"},
    {"tools/batch/cluster", "tools/batch/compare", "tools/batch/trials"},
    {"tools/batch/bench", "tools/batch/campaign", "tools/batch/dataset", "tools/batch/evaluate",
     "tools/batch/seeds"},
    // 9. twin
    {"tools/twin/alignment"},
    {"tools/twin/fits"},
    {"tools/twin/odometry"},
    {"tools/twin"},
    {"tools/twin/prediction"},
    // 10. pages
    {"tools/pages/html"},
    {"tools/pages/campaign/figures", "tools/pages/dataset", "tools/pages/run"},
    {"tools/pages/runs", "tools/pages/twin"},
    {"tools/pages/campaign"},
    // 11. live
    {"tools/live/lines"},
    {"tools/live/server"},
    {"tools/live"},
    // 12. commands
    {"tools/commands/arguments"},
    {"tools/commands"},
    {"tools/commands/bench"},
};

const Layers kLocalizationLayers = {
    {"localization/geometry"},
    {"localization/map", "localization/motion"},
    {"localization/space/map3d"},
    {"localization/space/volume"},
    {"localization/space/stack", "localization/sensor"},
    {"localization/space/ndt", "localization"},
    {"localization/filter", "localization/input", "localization/matching"},
    {"localization/hypotheses", "localization/amcl"},
    {"localization/search"},
    {"localization/mh_amcl"},
    {"localization/paper"},
    {"localization/paper/published"},
};

std::string room_of(const std::string& file) { return file.substr(0, file.rfind('/')); }

/// Layer of a folder; -1 if it is not listed.
int layer_of(const Layers& layers, const std::string& room) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (std::find(layers[i].begin(), layers[i].end(), room) != layers[i].end()) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

/// Includes within a library that do not point to a lower layer, as "file -> header".
Names against_layers(const Layers& layers, const std::string& library) {
  Names found;
  for (const Include& include : all_includes()) {
    const bool within = starts_with(include.file, library) && starts_with(include.header, library);
    const std::string from = room_of(include.file);
    const std::string to = room_of(include.header);
    if (!within || from == to) continue;
    const int low = layer_of(layers, to);
    if (low < 0 || low >= layer_of(layers, from)) {
      found.push_back(include.file + " -> " + include.header);
    }
  }
  return found;
}

TEST(Includes, RoomsOfTheLocalizersFormLayers) {
  EXPECT_EQ(against_layers(kLocalizationLayers, "localization/"), Names{});
}

TEST(Includes, RoomsOfXacroFormLayers) {
  EXPECT_EQ(against_layers({{"xacro/files"}, {"xacro"}}, "xacro/"), Names{});
}

TEST(Includes, RoomsOfTheSimulatorFormLayers) {
  EXPECT_EQ(against_layers(kSimLayers, "sim/"), Names{});
}

TEST(Includes, FloorsOfTheProgramAndTheirRoomsFormLayers) {
  EXPECT_EQ(against_layers(kToolsLayers, "tools/"), Names{});
}

TEST(Includes, ARoomInTheWrongLayerIsFound) {
  const Layers upside_down = {{"sim"}, {"sim/stages"}};
  EXPECT_FALSE(against_layers(upside_down, "sim/").empty());
}

/// A larger folder should be divided by subject.
TEST(Includes, NoRoomHoldsMoreThanThirtyFiles) {
  std::map<std::string, int> files;
  for (const char* part : kParts) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(CASTAWAY_SOURCE_DIR) / part)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".hpp" || extension == ".cpp") {
        ++files[fs::relative(entry.path().parent_path(), CASTAWAY_SOURCE_DIR).generic_string()];
      }
    }
  }
  EXPECT_GT(files.size(), 40U);
  for (const auto& [room, count] : files) EXPECT_LE(count, 30) << room;
}

TEST(Names, OfTheProductEndInNeitherTestNorSpec) {
  const fs::path root = CASTAWAY_SOURCE_DIR;
  for (const char* part : kParts) {
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string stem = entry.path().stem().string();
      EXPECT_FALSE(stem.ends_with("_test") || stem.ends_with("_spec")) << entry.path();
    }
  }
}

TEST(Includes, OnlyTheProgramReadsWallClocks) {
  EXPECT_EQ(
      violations(
          [](const std::string& h) { return h == "ctime" || h == "time.h" || h == "sys/time.h"; },
          [](const std::string& f) { return f == "tools/base/process/cpu_clock.cpp"; }),
      Names{});
}

/// Lines of our code that match a pattern.
Names lines_with(const std::regex& pattern) {
  const fs::path root = CASTAWAY_SOURCE_DIR;
  Names found;
  for (const char* part :
       {"localization", "xacro", "sim", "tools", "include", "public", "python", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".hpp" && extension != ".cpp") continue;
      if (entry.path().filename() == "includes_test.cpp") continue;
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        if (std::regex_search(line, pattern)) {
          found.push_back(fs::relative(entry.path(), root).generic_string() + ": " + line);
        }
      }
    }
  }
  return found;
}

TEST(Determinism, NothingDrawsFromForbiddenSources) {
  EXPECT_EQ(lines_with(std::regex(R"(random_device|\brand\(|::Random\(|\bsrand\()")), Names{});
  EXPECT_EQ(lines_with(std::regex(
                R"(std::(normal|uniform_real|uniform_int|bernoulli|poisson)_distribution)")),
            Names{});
}

/// A name that is not UTF-8 makes `dump` throw, after hours of work.
TEST(Json, IsWrittenByOneFunctionThatThrowsForNoName) {
  Names found = lines_with(std::regex(R"((\.|->)dump\()"));
  std::erase_if(found, [](const std::string& line) { return starts_with(line, "tests/"); });
  EXPECT_EQ(found.size(), 2U) << found.back();
  for (const std::string& line : found) {
    EXPECT_NE(line.find("error_handler_t::replace"), std::string::npos) << line;
  }
}

TEST(Determinism, NothingIteratesOverUnorderedContainers) {
  EXPECT_EQ(lines_with(std::regex(R"(unordered_(map|set))")), Names{});
}

}  // namespace
