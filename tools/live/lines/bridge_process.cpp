#include "tools/live/lines/bridge_process.hpp"

#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "tools/base/output/any_error.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/fork_child.hpp"
#include "tools/build/ros2/build_ros2.hpp"
#include "tools/live/lines/pipes.hpp"

namespace castaway::testbed {
namespace {

const std::string kReady = "ready";

/// Publishes until the line is cut. What is wrong before the line is ready, is told over it.
void be_bridge(const BridgeConfig& config, int socket) {
  std::shared_ptr<TopicWriter> wire;
  try {
    wire = build_wire(config);
  } catch (...) {
    write_whole(socket, current_error_text() + "\n");
    return;
  }
  write_whole(socket, kReady + "\n");
  try {
    publish_link(socket, *wire);
  } catch (...) {
    say(fmt::format("--ros2: {}", current_error_text()));
  }
}

}  // namespace

std::shared_ptr<BridgeLink> start_bridge(const BridgeConfig& config) {
  const int line = fork_child("the bridge to ROS 2", [&](int socket) {
                     std::signal(SIGINT, SIG_IGN);  // Its line is cut when the run ends.
                     be_bridge(config, socket);
                     return 0;
                   }).line;
  const std::string answer = read_line(line);
  if (answer == kReady) return std::make_shared<BridgeLink>(line);
  close(line);
  throw std::runtime_error("--ros2: " + (answer.empty() ? "the bridge broke off" : answer));
}

}  // namespace castaway::testbed
