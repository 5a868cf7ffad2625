/// gzip streams in memory.
#pragma once

#include <string>
#include <string_view>

namespace castaway::testbed {

/// `bytes` as a gzip stream without name or time: the same bytes give the same stream. Throws
/// std::runtime_error if there is no memory for it.
std::string gzip(std::string_view bytes);

/// What a gzip stream holds. Throws std::runtime_error if it is none, damaged or cut off.
std::string gunzip(std::string_view stream);

}  // namespace castaway::testbed
