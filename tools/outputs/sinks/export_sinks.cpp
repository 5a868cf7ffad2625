#include "tools/outputs/sinks/export_sinks.hpp"

#include "tools/outputs/sinks/carmen_sink.hpp"
#include "tools/outputs/sinks/kitti_sink.hpp"

namespace castaway::testbed {

std::vector<std::unique_ptr<RunSink>> export_sinks(const std::filesystem::path& run_folder,
                                                   const RunInfo& info, const RosMap& map,
                                                   const ExportConfig& config) {
  std::vector<std::unique_ptr<RunSink>> sinks;
  if (config.map) write_ros_map(map, run_folder / "map" / "map.yaml");
  if (config.bag) sinks.push_back(std::make_unique<BagSink>(run_folder, info, map, *config.bag));
  if (config.carmen) sinks.push_back(std::make_unique<CarmenSink>(run_folder));
  if (config.kitti) sinks.push_back(std::make_unique<KittiSink>(run_folder));
  return sinks;
}

}  // namespace castaway::testbed
