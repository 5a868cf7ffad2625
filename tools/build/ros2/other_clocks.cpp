#include "tools/build/ros2/other_clocks.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "tools/build/ros2/ros_qos.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kDiscovery(300);  // In which participants that are there are found.
constexpr milliseconds kLeave(3000);     // A run that ends may still be there.
constexpr milliseconds kBetweenLooks(20);

}  // namespace

OtherClocks::OtherClocks(DdsParticipant& participant, int domain)
    : clock_(participant, "/clock", ros_qos::kClock) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  while (clock_.publishers() > 0 || Clock::now() < begin + kDiscovery) {
    if (Clock::now() >= begin + kLeave) {
      throw std::runtime_error(fmt::format(
          "someone else publishes /clock in domain {}: give this run another domain", domain));
    }
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

}  // namespace castaway::testbed
