/// Helpers shared by the fuzzers and their corpus tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

/// Entry point of libFuzzer: reads `size` bytes at `data` as a file of the fuzzer's format. It
/// returns for any input; an error with a message counts as success.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace castaway::testbed {

/// The bytes as text.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Writes the bytes to a temporary file of this process, for readers that need a path; `ending`
/// includes its dot. Every call replaces the previous file.
std::filesystem::path as_file(const std::uint8_t* data, std::size_t size, std::string_view ending);

}  // namespace castaway::testbed
