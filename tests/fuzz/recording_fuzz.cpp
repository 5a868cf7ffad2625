// Fuzzes recording.gz as read by the report: whole files, and their unpacked bytes packed again.

#include <exception>
#include <string>

#include "tests/fuzz/fuzz_input.hpp"
#include "tools/base/bytes/gzip.hpp"
#include "tools/outputs/records/recording.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace castaway::testbed;
  const std::string bytes(text_of(data, size));
  for (const std::string& file : {bytes, gzip(bytes)}) {
    try {
      (void)map_of(unpack_recording(file));
    } catch (const std::exception&) {
    }
  }
  return 0;
}
