/// gzip streams in memory.
#pragma once

#include <string>
#include <string_view>

namespace castaway::testbed {

/// Compresses to a gzip stream without name and time, so that equal bytes give equal streams.
/// Throws std::runtime_error if memory runs out.
std::string gzip(std::string_view bytes);

/// Decompresses a gzip stream. Throws std::runtime_error if it is not one, damaged or truncated.
std::string gunzip(std::string_view stream);

}  // namespace castaway::testbed
