#include "tools/ros2/other_clocks.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "tools/ros2/ros_qos.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kDiscovery(300);  // In which participants that are there are found.
constexpr milliseconds kBetweenLooks(20);

}  // namespace

OtherClocks::OtherClocks(DdsParticipant& participant, int domain)
    : clock_(participant, "/clock", ros_qos::kClock) {
  const auto end = std::chrono::steady_clock::now() + kDiscovery;
  while (std::chrono::steady_clock::now() < end) {
    if (clock_.publishers() > 0) {
      throw std::runtime_error(fmt::format(
          "someone else publishes /clock in domain {}: give this run another domain", domain));
    }
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

}  // namespace castaway::testbed
