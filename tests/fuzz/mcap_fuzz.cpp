// Fuzzes MCAP bags, up to the frames that localizers receive.

#include <stdexcept>

#include "tests/fuzz/fuzz_input.hpp"
#include "tools/build/bag/bag_reading.hpp"
#include "tools/ros/bag_topics.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace castaway::testbed;
  try {
    const BagInventory bag = take_inventory("fuzz.mcap", {as_file(data, size, ".mcap")});
    BagTopicOptions in_space;
    in_space.in_space = true;
    read_bag(bag, choose_topics(bag, in_space), {true, {}});
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
