/// What fuzzers and their corpus tests share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

/// libFuzzer's entry: reads `size` bytes at `data` as a file of its format. Whatever they are, it
/// returns; an error that says what is wrong with them is as good as success.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace castaway::testbed {

/// The bytes as text.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Writes the bytes to a file of this process, for readers that take a path; `ending` with its dot.
/// Every call replaces the file of the one before.
std::filesystem::path as_file(const std::uint8_t* data, std::size_t size, std::string_view ending);

}  // namespace castaway::testbed
