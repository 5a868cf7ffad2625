/// Packing and unpacking the chunks of MCAP files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tools/ros/mcap/mcap_records.hpp"

namespace castaway::testbed {

/// The name of a compression in a file: "zstd", "lz4", "" for none.
std::string mcap_name_of(McapCompression compression);

/// The bytes as one frame of zstd (level 1) or lz4, or as they are. The same bytes and the same
/// library give the same frame.
std::string pack_chunk(std::string_view bytes, McapCompression compression);

/// What came out of a packed chunk.
struct UnpackedChunk {
  std::string bytes;
  bool whole = true;  ///< False: the packed bytes end too early; `bytes` is what they hold.
};

/// Unpacks zstd or lz4 frames, or copies. Never makes more than `most` bytes, whatever the packed
/// ones claim. Throws std::runtime_error on damage, on more than `most` bytes and on a compression
/// that is not known.
UnpackedChunk unpack_chunk(std::string_view packed, const std::string& compression,
                           std::uint64_t most);

}  // namespace castaway::testbed
