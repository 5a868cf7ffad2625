#include "tools/outputs/sinks/export_sinks.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/scenario/files/ros_map_file.hpp"

namespace castaway::testbed {
namespace {

const RosMap kMap{"m", 2, 2, 0.05, -1.0, 0.5, 0.0, {0, 100, -1, 0}};

TEST(ExportSinks, AreNoneWhereNothingIsAskedFor) {
  const TemporaryFolder folder;
  EXPECT_TRUE(export_sinks(folder.path(), run_of({}), kMap, {}).empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ExportSinks, LeaveWhatIsAskedFor) {
  const TemporaryFolder folder;
  ExportConfig all;
  all.bag = BagConfig{};
  all.carmen = all.kitti = all.map = true;
  for (auto& sink : export_sinks(folder.path(), run_of({}), kMap, all)) {
    sink->on_scan(record_at(1.0, {}));
    sink->finish({}, {});
  }
  for (const char* file : {"bag/metadata.yaml", "bag/a_scenario.mcap", "log.carmen",
                           "kitti/poses.txt", "kitti/times.txt", "map/map.yaml", "map/map.pgm"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / file)) << file;
  }
}

/// In map_server's format: a PGM (P5) and a YAML file with the thresholds of trinary maps.
TEST(ExportSinks, WriteAMapByTheRulesOfMapServer) {
  const TemporaryFolder folder;
  ExportConfig config;
  config.map = true;
  export_sinks(folder.path(), run_of({}), kMap, config);
  EXPECT_EQ(read_file(folder.path() / "map" / "map.pgm"),
            "P5\n2 2\n255\n\xCD\xFE\xFE" + std::string(1, '\0'));
  const std::string yaml = read_file(folder.path() / "map" / "map.yaml");
  for (const char* line :
       {"image: map.pgm\n", "mode: trinary\n", "resolution: 0.05\n", "origin: [-1.0, 0.5, 0.0]\n",
        "negate: 0\n", "occupied_thresh: 0.65\n", "free_thresh: 0.196\n"}) {
    EXPECT_TRUE(contains(yaml, line));
  }
  EXPECT_EQ(load_ros_map(folder.path() / "map" / "map.yaml").cells, kMap.cells);
}

}  // namespace
}  // namespace castaway::testbed
