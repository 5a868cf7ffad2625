#include "tools/live/bridge/bridge_process.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "tools/base/output/any_error.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/worker_process.hpp"
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
  std::array<int, 2> ends{};  // Ours, the bridge's.
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
    throw std::runtime_error("cannot start the bridge to ROS 2: no socket");
  }
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error("cannot start the bridge to ROS 2: no process");
  if (process == 0) {
    close(ends[0]);
    std::signal(SIGINT, SIG_IGN);  // Its line is cut when the run ends.
    be_bridge(config, ends[1]);
    _exit(0);
  }
  close(ends[1]);
  const std::string answer = read_line(ends[0]);
  if (answer == kReady) return std::make_shared<BridgeLink>(ends[0]);
  close(ends[0]);
  throw std::runtime_error("--ros2: " + (answer.empty() ? "the bridge broke off" : answer));
}

}  // namespace castaway::testbed
