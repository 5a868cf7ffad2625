/// Compresses and decompresses chunks of files, as MCAP files have them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// How a chunk is compressed.
enum class Compression : std::uint8_t { kNone, kZstd, kLz4 };

/// Name of a compression in a file: "zstd", "lz4", "" for none.
std::string compression_name(Compression compression);

/// Compresses to one frame of zstd (level 1) or lz4, or copies. Deterministic for a version of the
/// library.
std::string pack_chunk(std::string_view bytes, Compression compression);

/// Result of unpacking a chunk.
struct UnpackedChunk {
  std::string bytes;
  bool whole = true;  ///< False if the packed bytes are truncated; `bytes` then holds the part
                      ///< before.
};

/// Unpacks zstd or lz4 frames, or copies. Never produces more than `most` bytes, whatever the
/// packed data claim. Throws std::runtime_error on damage, on more than `most` bytes and on an
/// unknown compression.
UnpackedChunk unpack_chunk(std::string_view packed, const std::string& compression,
                           std::uint64_t most);

}  // namespace castaway::testbed
