// Fuzzes SDF worlds, without the files that they refer to.

#include <stdexcept>

#include "sim/world/sdf/load_sdf.hpp"
#include "tests/fuzz/fuzz_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace castaway;
  const auto path = testbed::as_file(data, size, ".sdf");
  try {
    (void)sim::load_sdf(path.string(), {});
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  } catch (const std::length_error&) {
  }
  return 0;
}
