// The directions in which parts of the project may include each other.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// An include line: who, and what it names.
struct Include {
  std::string file;    ///< From the root of the project.
  std::string header;  ///< Between the quotes or brackets.
};

bool starts_with(const std::string& text, const std::string& prefix) {
  return text.rfind(prefix, 0) == 0;
}

std::vector<Include> all_includes() {
  static const std::regex line_of(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  const fs::path root = CASTAWAY_SOURCE_DIR;
  std::vector<Include> includes;
  for (const char* part : {"localization", "sim", "tools"}) {
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

/// All includes of `header` that match and are not allowed, as "file -> header".
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

TEST(Includes, LocalizationKnowsNothingButEigenBoostAndTheStandardLibrary) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return h.find('.') != std::string::npos && !starts_with(h, "localization/") &&
                         !starts_with(h, "boost/random/");
                },
                [](const std::string& f) { return !starts_with(f, "localization/"); }),
            Names{});
}

TEST(Includes, SimKnowsNeitherLocalizationNorTools) {
  EXPECT_EQ(violations(
                [](const std::string& h) {
                  return starts_with(h, "localization/") || starts_with(h, "tools/") ||
                         starts_with(h, "yaml-cpp/");
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

TEST(Includes, RunMetricsAndFormatsLinkWithoutTheSimulator) {
  const std::set<std::string> conversions = {
      "tools/sources/build_drive.cpp",      "tools/sources/build_drive.hpp",
      "tools/sources/build_robot.cpp",      "tools/sources/build_robot.hpp",
      "tools/sources/build_sensors.cpp",    "tools/sources/build_sensors.hpp",
      "tools/sources/build_simulation.cpp", "tools/sources/build_simulation.hpp",
      "tools/sources/build_world.cpp",      "tools/sources/build_world.hpp",
      "tools/sources/scan_truth.cpp",       "tools/sources/scan_truth.hpp",
      "tools/sources/simulator_source.cpp", "tools/sources/simulator_source.hpp"};
  EXPECT_EQ(
      violations(
          [&](const std::string& h) { return starts_with(h, "sim/") || conversions.contains(h); },
          [&](const std::string& f) {
            const bool bound = starts_with(f, "tools/run/") || starts_with(f, "tools/metrics/") ||
                               starts_with(f, "tools/formats/");
            return !bound || conversions.contains(f);
          }),
      Names{});
}

TEST(Includes, OnlyTheProgramReadsWallClocks) {
  EXPECT_EQ(
      violations(
          [](const std::string& h) { return h == "ctime" || h == "time.h" || h == "sys/time.h"; },
          [](const std::string& f) { return f == "tools/run/cpu_clock.cpp"; }),
      Names{});
}

/// Lines of our code that match a pattern.
Names lines_with(const std::regex& pattern) {
  const fs::path root = CASTAWAY_SOURCE_DIR;
  Names found;
  for (const char* part : {"localization", "sim", "tools", "tests"}) {
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

TEST(Determinism, NothingIteratesOverUnorderedContainers) {
  EXPECT_EQ(lines_with(std::regex(R"(unordered_(map|set))")), Names{});
}

}  // namespace
