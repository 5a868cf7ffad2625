#include "tools/outputs/sinks/bag_sink.hpp"

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/base/formats/volume/stance_texts.hpp"
#include "tools/ros/ros_conversion.hpp"
#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed {
namespace {

void attach_inputs(const BagConfig& config, const RosMap& map, BagWriter& bag) {
  bag.attach("scenario.yaml", "application/yaml", config.scenario_yaml);
  bag.attach("map.yaml", "application/yaml", ros_map_yaml(map, "map.pgm"));
  bag.attach("map.pgm", "image/x-portable-graymap", encode_pgm(map_image(map)));
  if (config.robot_file.empty()) return;
  bag.attach(config.robot_file.filename().string(), "application/xml",
             read_file(config.robot_file));
}

std::map<std::string, std::string> run_metadata(const RunInfo& info, const BagConfig& config) {
  std::map<std::string, std::string> run = {{"castaway", CASTAWAY_VERSION},
                                            {"scenario", info.scenario},
                                            {"world", info.world},
                                            {"robot", info.robot},
                                            {"seed", std::to_string(info.seed)},
                                            {"time_0_ns", std::to_string(kBagEpoch.count())}};
  if (const auto& start = config.start) {
    run["start"] = fmt::format("{} {} {}", start->x, start->y, start->yaw);
  }
  run.merge(texts_of(config.wheels));
  return run;
}

}  // namespace

BagSink::BagSink(const std::filesystem::path& run_folder, const RunInfo& info, const RosMap& map,
                 BagConfig config)
    : config_(std::move(config)),
      bag_(run_folder / "bag", info.scenario, config_.options.compression),
      messages_(info,
                {config_.links, config_.lidars, config_.options.particles, config_.drive,
                 config_.options.points, config_.options.clouds},
                bag_),
      snapshots_(run_folder) {
  attach_inputs(config_, map, bag_);
  bag_.add_metadata("run", run_metadata(info, config_));
  messages_.begin(map);
}

/// Pictures are taken after this sink has handled a scan, so they are logged with the next one.
void BagSink::write_snapshots(Stamp delivered) {
  if (!config_.options.snapshots) return;
  for (Snapshot& snapshot : snapshots_.take_new()) {
    const auto [topic, first] = views_.try_emplace(snapshot.view);
    if (first) {
      topic->second =
          bag_.add_topic<ros::CompressedImage>("/snapshot/" + topic_part(snapshot.view));
    }
    bag_.publish(
        topic->second, delivered,
        ros::CompressedImage{
            ros_header(snapshot.stamp, "map"), "png", {snapshot.png.begin(), snapshot.png.end()}});
  }
}

void BagSink::on_scan(const ScanRecord& record) {
  write_snapshots(record.delivered);
  messages_.on_scan(record);
}

void BagSink::finish(Stamp end, const RunTiming&) {
  write_snapshots(end);
  if (config_.label_name) {
    std::map<std::string, std::string> names;
    for (const int label : messages_.labels()) {
      names[std::to_string(label)] = config_.label_name(label);
    }
    bag_.add_metadata("labels", names);
  }
  bag_.finish();
}

}  // namespace castaway::testbed
