/// The LZF format of Marc Lehmann's LibLZF, which PCD files use.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Decompresses `packed`, of less than 4 GiB, to exactly `size` bytes; nullopt if it is damaged or
/// holds another number of bytes. Memory is reserved for at most 88 times the size of `packed`.
std::optional<std::string> decompress_lzf(std::string_view packed, std::size_t size);

}  // namespace castaway::testbed
