// Runs every command line in a code block of README and docs in a folder with the files that it
// names. Only placeholders, durations and numbers of runs are replaced.
#include <regex>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

const fs::path kSource = CASTAWAY_SOURCE_DIR;

/// A command line of a page.
struct Shown {
  std::string page;
  std::string arguments;  ///< Without the program's name and anything after "#" or "&&".
};

std::string without_comment(std::string line) {
  for (const char* mark : {" #", " &&"}) line = line.substr(0, line.find(mark));
  return line.substr(0, line.find_last_not_of(" \t") + 1);
}

/// Commands in the code blocks of a page.
std::vector<Shown> commands_in(const fs::path& page) {
  static const std::regex kCommand(
      R"(^\s*(?:(?:- )?run: )?(?:castaway/)?(?:build/release/)?castaway (.*))");
  std::istringstream text(std::regex_replace(text_of(page), std::regex(R"(\\\n)"), " "));
  std::vector<Shown> commands;
  bool block = false;
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) block = !block;
    if (!block || !std::regex_match(line, match, kCommand)) continue;
    commands.push_back({page.filename().string(), without_comment(match[1])});
  }
  return commands;
}

/// README and the pages of docs that show commands, from the root.
std::vector<std::string> pages() {
  std::vector<std::string> found{"README.md"};
  for (const char* part : {"docs", "docs/theory"}) {  // scripts/measure runs those of docs/figures.
    for (const auto& entry : fs::directory_iterator(kSource / part)) {
      const fs::path& page = entry.path();
      if (page.filename() == "your-localizer.md") continue;  // Tried word by word.
      if (page.extension() != ".md" || commands_in(page).empty()) continue;
      found.push_back(fs::relative(page, kSource).string());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
  return std::regex_replace(text, std::regex(what), by);
}

/// The command with smaller numbers of runs and shorter durations.
std::string small(std::string line) {
  line = replaced(line, R"(--seeds \d+)", "--seeds 2");
  line = replaced(line, R"(--duration \d+)", "");
  line = replaced(line, R"(~/)", "home/");
  if (line.starts_with("run")) {
    line += " --duration 3";
    if (line.find("--video") == std::string::npos) line += " --set outputs.snapshots=false";
  }
  if (line.starts_with("experiment")) line = replaced(line, "--seeds 2", "") + " --quick";
  if (line.starts_with("evaluate")) line += " --starts 1 --kidnaps 0 --window 2 --no-tracking";
  if (line.starts_with("twin ")) line += " --starts 1 --kidnaps 0 --window 2";
  if (line.starts_with("replay")) line += " --no-pictures --out replay --force --scans 3";
  if (line.starts_with("dataset")) line = replaced(line, R"(-n \d+)", "-n 1");
  if (line.starts_with("campaign")) line = replaced(line, "lidar-range", "tiny");
  if (line.starts_with("bench calibration")) line = "bench calibration --trials 1 --duration 120";
  if (line.starts_with("bench kidnaps"))
    line = replaced(line, R"(--kidnaps \d+)", "") + " --kidnaps 1";
  if (line.starts_with("bench simulation") || line.starts_with("bench localization"))
    line += " --quick";
  return line;
}

/// An SDF room of 8 x 6 m with four walls and a pillar.
const char* const kWorld = R"(<sdf version="1.6"><world name="mine">
<model name="floor"><static>true</static><link name="l"><collision name="c"><geometry><plane>
<normal>0 0 1</normal><size>8 6</size></plane></geometry></collision></link></model>
<model name="walls"><static>true</static><link name="l">
<collision name="n"><pose>0 3 1 0 0 0</pose><geometry><box><size>8 0.1 2</size></box></geometry></collision>
<collision name="s"><pose>0 -3 1 0 0 0</pose><geometry><box><size>8 0.1 2</size></box></geometry></collision>
<collision name="e"><pose>4 0 1 0 0 0</pose><geometry><box><size>0.1 6 2</size></box></geometry></collision>
<collision name="w"><pose>-4 0 1 0 0 0</pose><geometry><box><size>0.1 6 2</size></box></geometry></collision>
<collision name="p"><pose>2 1 1 0 0 0</pose><geometry><box><size>0.4 0.8 2</size></box></geometry></collision>
</link></model></world></sdf>
)";

/// Makes the files that the pages' commands name.
fs::path make_inputs(const fs::path& folder) {
  fs::create_directories(folder);
  for (const char* name : {"worlds", "robots", "datasets", "campaigns", "examples"}) {
    fs::create_directory_symlink(kSource / name, folder / name);
  }
  EXPECT_EQ(castaway(folder,
                     "run --duration 60 --set events=[] --set outputs.snapshots=false --set "
                     "outputs.carmen=true --set outputs.map=true --set outputs.bag=true --out made")
                .exit_code,
            0);
  // The run of the README's first command, which others name.
  EXPECT_EQ(castaway(folder, "run --duration 3 --set outputs.snapshots=false").exit_code, 0);
  const fs::path map = folder / "made/map/map.yaml";
  for (const char* place : {"intel", "freiburg-079", "aces", "folder_with_log_and_map"}) {
    fs::create_directories(folder / place);
    fs::copy(folder / "made/log.carmen", folder / place / "log.carmen");
    fs::copy(folder / "made/map/map.pgm", folder / place / "map.pgm");
    fs::copy(map, folder / place / "map.yaml");
  }
  fs::copy(folder / "made/map/map.pgm", folder / "map.pgm");
  for (const char* name : {"map.yaml", "my_map.yaml", "office.yaml", "MAP"}) {
    fs::copy(map, folder / name);
  }
  for (const char* name : {"log.carmen.gz", "aces.log.gz", "freiburg-079.log.gz", "intel.log.gz"}) {
    const std::string command = "gzip -c '" + (folder / "made/log.carmen").string() + "' > '" +
                                (folder / name).string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
  EXPECT_EQ(castaway(folder, "map lab --out building.bt").exit_code, 0);
  fs::copy(folder / "made/log.carmen", folder / "LOG");
  fs::copy(folder / "made/bag", folder / "rosbag2_2026_01_31", fs::copy_options::recursive);
  const std::string robot = text_of(kSource / "robots/disc/disc.urdf");
  std::ofstream(folder / "my_robot.urdf") << robot;
  std::ofstream(folder / "my_robot.urdf.xacro")
      << replaced(robot, "<robot name=\"disc\">",
                  "<robot name=\"disc\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">"
                  "<xacro:arg name=\"prefix\" default=\"\"/>");
  std::ofstream(folder / "my_world.sdf") << kWorld;
  fs::create_directories(folder / "ci");
  for (const char* name : {"my.yaml", "my_scenario.yaml", "ci/localizer.yaml"}) {
    std::ofstream(folder / name) << "name: " << fs::path(name).stem().string() << "\nworld: lab\n";
  }
  fs::create_directories(folder / "home/ws/src");
  fs::create_directories(folder / "home/models");
  return folder;
}

/// A folder with the files that the pages' commands name. They are made once for all pages.
fs::path folder_with_inputs() {
  const fs::path folder = fresh_folder();
  static const fs::path inputs = make_inputs(folder / "inputs");
  fs::copy(inputs, folder / "page", fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  return folder / "page";
}

/// True for commands that use topics which no bag of castaway has.
bool names_foreign_topics(const std::string& line) {
  return line.find("/vicon/pose") != std::string::npos;
}

/// True for commands that need a cluster; slurm_test.cpp has them.
bool needs_slurm(const std::string& line) {
  return line.find("--slurm") != std::string::npos || line.find("--attach") != std::string::npos;
}

class DocumentedCommands : public testing::TestWithParam<std::string> {};

TEST_P(DocumentedCommands, Work) {
  const fs::path folder = folder_with_inputs();
  const bool films = std::system("ffmpeg -version >/dev/null 2>&1") == 0;
  for (const Shown& shown : commands_in(kSource / GetParam())) {
    if (names_foreign_topics(shown.arguments) || needs_slurm(shown.arguments)) continue;
    if (!films && shown.arguments.find("--video") != std::string::npos) continue;
    // gate-of-main is the result of another branch, which the page's CI job downloads.
    if (shown.arguments.find("gate-of-main") != std::string::npos) {
      fs::copy(folder / "gate", folder / "gate-of-main", fs::copy_options::recursive);
    }
    const Outcome outcome = castaway(folder, small(shown.arguments));
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3)
        << shown.page << ": castaway " << shown.arguments << "\nas: castaway "
        << small(shown.arguments) << "\n"
        << outcome.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, DocumentedCommands, testing::ValuesIn(pages()), path_name);

TEST(DocumentedPages, AreFound) { EXPECT_GT(pages().size(), 15U); }

/// The first code block of a page that begins with these words.
std::string block_of(const fs::path& page, const std::string& begin) {
  const std::string text = text_of(page);
  const std::size_t from = text.find("\n" + begin);
  EXPECT_NE(from, std::string::npos) << page << ": " << begin;
  return text.substr(from + 1, text.find("\n```", from) - from);
}

// The complete scenario and world files on the pages.
TEST(DocumentedPages, HaveExamplesOfFilesThatLoad) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "gate.yaml") << block_of(kSource / "docs/ci.md", "name: localizer-gate");
  EXPECT_EQ(castaway(folder, "run gate.yaml --duration 65 --out gate").exit_code, 0);
  fs::create_directories(folder / "flat/meshes");
  std::ofstream(folder / "flat/world.yaml") << block_of(kSource / "docs/worlds.md", "name: flat");
  std::ofstream(folder / "flat/meshes/plant.obj")
      << "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nv 0 0 0.8\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n";
  const Outcome map = castaway(folder, "map flat --out flat/map.yaml");
  EXPECT_EQ(map.exit_code, 0) << map.err;
  const Outcome run = castaway(
      folder, "run --world flat --duration 5 --set events=[] --set outputs.snapshots=false");
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

}  // namespace
}  // namespace castaway::test
