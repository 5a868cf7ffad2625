// Fuzzes URDF and xacro up to the loaded robot.

#include <stdexcept>

#include "sim/robot/load_robot.hpp"
#include "tests/fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace castaway;
  const auto path = testbed::as_file(data, size, ".urdf.xacro");
  try {
    (void)sim::load_robot(path.string(), {});
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  } catch (const std::length_error&) {
  }
  return 0;
}
