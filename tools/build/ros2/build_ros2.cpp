#include "tools/build/ros2/build_ros2.hpp"

#include <utility>

#include "tools/build/ros2/bridge_sink.hpp"
#include "tools/build/ros2/ros2_localizer.hpp"

namespace castaway::testbed {

NamedLocalizer build_ros2(const Ros2Config& config, const Greeting& greeting) {
  auto node = std::make_unique<Ros2Localizer>(config, greeting);
  Ros2Localizer* running = node.get();
  NamedLocalizer localizer{greeting.name, std::move(node)};
  localizer.news = [running] { return running->take_news(); };
  if (running->drives()) localizer.velocity = [running] { return running->velocity(); };
  localizer.finish = [running] { return OutsideUse{{}, 0.0, running->counts()}; };
  return localizer;
}

std::unique_ptr<RunSink> build_bridge(const RunInfo& info, const RosMap& map, BridgeConfig config) {
  return std::make_unique<BridgeSink>(info, map, std::move(config));
}

std::shared_ptr<TopicWriter> build_wire(const BridgeConfig& config) {
  const auto wire = std::make_shared<OwnWire>(config.options, config.without_robot);
  return {wire, &wire->writer()};
}

}  // namespace castaway::testbed
