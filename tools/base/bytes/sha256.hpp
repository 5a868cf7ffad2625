/// SHA-256 (FIPS 180-4), as `sha256sum` prints it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Hash as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// Hash of a file, which is read in pieces. Throws std::runtime_error naming the file if it cannot
/// be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace castaway::testbed
