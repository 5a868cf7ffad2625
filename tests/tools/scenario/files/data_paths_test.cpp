#include "tools/scenario/files/data_paths.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

std::string robot_error(const fs::path& path) {
  return error_of([&] { find_robot(path.string(), "."); });
}

TEST(DataPaths, SayWhatIsWrongWithAPath) {
  const TemporaryFolder folder;
  write_file(folder.path() / "mine.urdf", "<robot/>");
  fs::create_directories(folder.path() / "mine_description");
  fs::create_symlink(folder.path() / "gone", folder.path() / "link.urdf");
  EXPECT_TRUE(contains(robot_error(folder.path() / "mien.urdf"),
                       "mien.urdf': no such file; did you mean '"));
  EXPECT_TRUE(contains(robot_error(folder.path() / "other/mine.urdf"),
                       "': no such file: there is no folder '"));
  EXPECT_TRUE(contains(robot_error(folder.path() / "mine_description"),
                       "': is a folder without mine_description.urdf, "));
  EXPECT_TRUE(contains(robot_error(folder.path() / "link.urdf"), "a link to a file that does not"));
  EXPECT_TRUE(contains(robot_error("/dev/null"), "'/dev/null': is no regular file"));
  EXPECT_TRUE(contains(robot_error("gone/robot"), "'gone/robot': no such file: there is no"));
  EXPECT_TRUE(contains(error_of([] { find_world("nowhere.sdf", "."); }),
                       "world 'nowhere.sdf': no such file in the current folder"));
}

TEST(DataPaths, ListNamesWhereANameIsUnknown) {
  EXPECT_TRUE(contains(robot_error("wafle"),
                       "robot 'wafle' not found: did you mean 'waffle'? Or "
                       "give a path, or one of: butler, "));
  EXPECT_TRUE(contains(robot_error("aeroplane"), "not found: give a path, or one of: butler, "));
}

TEST(DataPaths, SayWhatIsWrongWithAScenariosPath) {
  const auto scenario_error = [](const char* text) {
    return error_of([&] { find_scenario(text, "."); });
  };
  EXPECT_EQ(scenario_error("nowhere.yaml"), "nowhere.yaml: no such file in the current folder");
  EXPECT_TRUE(contains(scenario_error("/gone/my.yaml"), "there is no folder '/gone'"));
  EXPECT_TRUE(contains(scenario_error("lab/kidnp"), "no such scenario; did you mean 'lab/kidnap'"));
}

}  // namespace
}  // namespace castaway::testbed
