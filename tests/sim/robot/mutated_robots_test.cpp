// Randomly damaged robots are loaded or rejected, without a crash and within a short time.
#include <array>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "sim/common/random.hpp"
#include "sim/robot/load_robot.hpp"
#include "tests/support/robot_files.hpp"

namespace castaway::sim {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::size_t draw(std::size_t below, Rng& rng) { return static_cast<std::size_t>(rng() % below); }

/// Replaces the value of one attribute, so that the XML remains well-formed.
void replace_value(std::string& text, Rng& rng) {
  constexpr std::array<const char*, 18> kValues{
      "",           "0",           "-1",        "nan",   "1e9",        "1 2",
      "${1 / 0}",   "${name}",     "base_link", "true",  "${x y}",     "$(arg no)",
      "continuous", "${'a' * 99}", "..",        "fixed", "${-radius}", "0 0 1"};
  const std::size_t equals = text.find("=\"", draw(text.size(), rng));
  if (equals == std::string::npos) return;
  const std::size_t end = text.find('"', equals + 2);
  if (end == std::string::npos) return;
  text.replace(equals + 2, end - equals - 2, kValues.at(draw(kValues.size(), rng)));
}

/// Changes a byte, or removes or duplicates a part.
void damage(std::string& text, Rng& rng) {
  const std::size_t at = draw(text.size(), rng);
  const std::size_t length = draw(std::min<std::size_t>(60, text.size() - at), rng);
  switch (draw(3, rng)) {
    case 0:
      text[at] = static_cast<char>(draw(256, rng));
      break;
    case 1:
      text.erase(at, length);
      break;
    default:
      text.insert(at, text.substr(at, length));
  }
}

std::string mutated(std::string text, Rng& rng) {
  for (std::size_t n = 1 + draw(3, rng); n > 0; --n) {
    draw(4, rng) == 0 ? damage(text, rng) : replace_value(text, rng);
  }
  return text;
}

class MutatedRobots : public RobotFiles, public testing::WithParamInterface<const char*> {
 protected:
  void copy(const std::string& path) const {
    write(path, text_of(std::string(CASTAWAY_ROBOTS "/") + path));
  }
};

TEST_P(MutatedRobots, AreLoadedOrRefused) {
  for (const char* part :
       {"butler/parts/inertia.xacro", "butler/parts/wheels.xacro", "butler/parts/lidar.xacro",
        "butler/parts/torso.xacro", "mule/parts/inertia.xacro", "mule/parts/wheel.xacro"}) {
    copy(part);
  }
  const std::string original = text_of(std::string(CASTAWAY_ROBOTS "/") + GetParam());
  Rng rng(7);
  int loaded = 0;
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    const std::string path = write(GetParam(), mutated(original, rng));
    const std::string problem = error_text([&] { (void)load_robot(path); });
    problem.empty() ? ++loaded : ++refused;
    EXPECT_TRUE(problem.empty() || problem.find("urdf") != std::string::npos) << problem;
  }
  EXPECT_GT(loaded, 10);
  EXPECT_GT(refused, 10);
}

INSTANTIATE_TEST_SUITE_P(Files, MutatedRobots,
                         testing::Values("disc/disc.urdf", "butler/butler.urdf.xacro",
                                         "mule/mule.urdf.xacro"));

}  // namespace
}  // namespace castaway::sim
