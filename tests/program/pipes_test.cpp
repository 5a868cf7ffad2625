// Files that are not regular: a pipe without a writer, an endless device. Every command that takes
// a file name rejects them at once with one line.
#include <sys/stat.h>

#include <algorithm>
#include <functional>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// A command that reads a file.
struct Place {
  const char* name;
  const char* file;     ///< Path of the pipe.
  const char* command;  ///< The command that reads it.
};

void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }

const char* const kMap =
    "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

class Pipes : public testing::TestWithParam<Place> {
 protected:
  void SetUp() override {
    folder_ = fresh_folder();
    write(folder_ / "map.yaml", kMap);
    write(folder_ / "map.pgm", "P5\n2 2\n255\n" + std::string(4, '\0'));
    write(folder_ / "log/map.yaml", kMap);
    write(folder_ / "log/map.pgm", "P5\n2 2\n255\n" + std::string(4, '\0'));
    write(folder_ / "run/summary.json", R"({"localizers": {}, "scenario": "s", "seed": 1})");
    write(folder_ / "run/errors.csv", "stamp_s,localizer\n");
    write(folder_ / "run/events.csv", "stamp_s,kind\n");
    write(folder_ / "d.yaml", "scenario: {world: lab}\n");
    write(folder_ / "good.carmen", "ODOM 0 0 0 0 0 0 1 h 1\nFLASER 3 1 1 1 0 0 0 0 0 0 1 h 1\n");
    fs::create_directories(folder_ / "run/snapshots");
  }
  /// Replaces the file by something else and runs the command.
  void expect_refused(const std::function<void(const fs::path&)>& make) {
    const fs::path file = folder_ / GetParam().file;
    fs::remove(file);
    fs::create_directories(file.parent_path());
    make(file);
    const Outcome tried = castaway(folder_, GetParam().command, "timeout 15");
    EXPECT_TRUE(tried.exit_code == 1 || tried.exit_code == 2) << tried.exit_code << tried.err;
    EXPECT_EQ(std::count(tried.err.begin(), tried.err.end(), '\n'), 1) << tried.err;
    expect_contains(tried.err, file.filename().string());
  }
  fs::path folder_;
};

TEST_P(Pipes, AreRefusedInOneLine) {
  expect_refused([](const fs::path& file) { ASSERT_EQ(mkfifo(file.c_str(), 0600), 0); });
}

TEST_P(Pipes, AreRefusedAsDevicesToo) {
  expect_refused([](const fs::path& file) { fs::create_symlink("/dev/zero", file); });
}

INSTANTIATE_TEST_SUITE_P(
    , Pipes,
    testing::Values(Place{"scenario", "s.yaml", "run s.yaml"},
                    Place{"map", "map.yaml", "run --world map.yaml --duration 1"},
                    Place{"map_image", "map.pgm", "run --world map.yaml --duration 1"},
                    Place{"world", "w.yaml", "check-world w.yaml --no-picture"},
                    Place{"sdf", "w.sdf", "check-world w.sdf --no-picture"},
                    Place{"urdf", "r.urdf", "check-robot r.urdf --no-picture"},
                    Place{"xacro", "r.urdf.xacro", "check-robot r.urdf.xacro --no-picture"},
                    Place{"joints", "j.yaml", "check-robot waffle --joints j.yaml --no-picture"},
                    Place{"twist_log", "t.csv", "run --set drive.twist_log=t.csv --duration 1"},
                    Place{"carmen_log", "l.carmen", "replay l.carmen --map map.yaml"},
                    Place{"bag", "b.mcap", "replay b.mcap --map map.yaml"},
                    Place{"bag_of", "b.mcap", "bag b.mcap"},
                    Place{"map_of_replay", "map.yaml", "replay good.carmen --map map.yaml"},
                    Place{"evaluate", "log/l.clf", "evaluate log"},
                    Place{"dataset", "d.yaml", "dataset d.yaml --out ds"},
                    Place{"summary", "run/summary.json", "report run"},
                    Place{"errors", "run/errors.csv", "report run"},
                    Place{"events", "run/events.csv", "report run"},
                    Place{"timing", "run/timing.json", "report run"},
                    Place{"recording", "run/recording.gz", "report run"},
                    Place{"picture", "run/snapshots/t0.png", "report run"},
                    Place{"compared", "run/summary.json", "compare run run"}),
    [](const auto& place) { return std::string(place.param.name); });

TEST(DeepJson, IsRefusedByReportAndCompare) {
  const fs::path folder = fresh_folder();
  for (const int depth : {5000, 1000000}) {
    write(folder / "run/summary.json", std::string(static_cast<std::size_t>(depth), '['));
    for (const char* command : {"report run", "compare run run"}) {
      const Outcome outcome = castaway(folder, command, "timeout 15");
      EXPECT_TRUE(outcome.exit_code == 1 || outcome.exit_code == 2) << outcome.exit_code;
      expect_contains(outcome.err, "summary.json: JSON nested more than 100 deep");
    }
  }
}

}  // namespace
}  // namespace castaway::test
