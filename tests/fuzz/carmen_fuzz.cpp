// Fuzzes CARMEN logs, plain and gzipped, up to the frames that localizers receive.

#include <stdexcept>

#include "tests/fuzz/fuzz_input.hpp"
#include "tools/build/recorded/carmen_source.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace castaway::testbed;
  try {
    CarmenSource source(as_file(data, size, ".clf"));
    while (source.next()) {
    }
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
