// Fuzzes YAML: the parser, scenarios, worlds and maps.

#include <stdexcept>

#include "tests/fuzz/fuzz_input.hpp"
#include "tools/scenario/files/ros_map_file.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/scenario/world/world_file.hpp"

namespace {

/// Bad input must be rejected with a message; any other exception ends the fuzzer.
template <typename Read>
void tried(Read read) {
  try {
    read();
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace castaway::testbed;
  const std::string text(text_of(data, size));
  tried([&] { emit_yaml(parse_yaml(text, "fuzz.yaml")); });
  const auto path = as_file(data, size, ".yaml");
  tried([&] { load_scenario(path, {}); });
  tried([&] { load_world(path); });
  tried([&] { load_ros_map(path); });
  return 0;
}
