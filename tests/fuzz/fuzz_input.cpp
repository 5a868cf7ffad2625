#include "tests/fuzz/fuzz_input.hpp"

#include <unistd.h>

#include <fstream>
#include <string>

namespace castaway::testbed {

std::filesystem::path as_file(const std::uint8_t* data, std::size_t size, std::string_view ending) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("castaway-fuzz-" + std::to_string(getpid()) + std::string(ending));
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text_of(data, size);
  return path;
}

}  // namespace castaway::testbed
