#include "tools/base/bytes/compression.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

namespace castaway::testbed {
namespace {

constexpr int kZstdLevel = 1;  // Fast; bags of scans are a few per cent larger than at level 3.
constexpr std::size_t kInflateStep = 256 << 10;  // Growth of the output buffer.

[[noreturn]] void refuse(const char* compression, const char* why) {
  throw std::runtime_error(fmt::format("its {} frame is damaged ({})", compression, why));
}

std::string pack_zstd(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kZstdLevel);
  if (ZSTD_isError(size)) throw std::runtime_error("zstd: cannot compress");
  packed.resize(size);
  return packed;
}

std::string pack_lz4(std::string_view bytes) {
  std::string packed(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  const std::size_t size =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr);
  if (LZ4F_isError(size)) throw std::runtime_error("lz4: cannot compress");
  packed.resize(size);
  return packed;
}

/// Grows the output buffer, to at most one byte more than `most`.
std::size_t grow(std::string& bytes, std::uint64_t most) {
  const std::size_t used = bytes.size();
  if (used > most) {
    throw std::runtime_error(fmt::format("it unpacks to more than the {} bytes it may have", most));
  }
  bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(used + kInflateStep, most + 1)));
  return bytes.size() - used;
}

UnpackedChunk unpack_zstd(std::string_view packed, std::uint64_t most) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                          ZSTD_freeDStream);
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  UnpackedChunk chunk;
  std::size_t wanted = packed.empty() ? 0 : 1;
  for (bool more = wanted > 0; more;) {
    const std::size_t used = chunk.bytes.size();
    const std::size_t room = grow(chunk.bytes, most);
    ZSTD_outBuffer out{chunk.bytes.data() + used, room, 0};
    wanted = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(wanted)) refuse("zstd", ZSTD_getErrorName(wanted));
    chunk.bytes.resize(used + out.pos);
    more = in.pos < in.size || (wanted != 0 && out.pos == room);
  }
  chunk.whole = wanted == 0;
  return chunk;
}

UnpackedChunk unpack_lz4(std::string_view packed, std::uint64_t most) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION))) throw std::bad_alloc();
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      made, LZ4F_freeDecompressionContext);
  UnpackedChunk chunk;
  std::size_t at = 0;
  std::size_t wanted = packed.empty() ? 0 : 1;
  for (bool more = wanted > 0; more;) {
    const std::size_t used = chunk.bytes.size();
    const std::size_t room = grow(chunk.bytes, most);
    std::size_t made_bytes = room;
    std::size_t taken = packed.size() - at;
    wanted = LZ4F_decompress(context.get(), chunk.bytes.data() + used, &made_bytes,
                             packed.data() + at, &taken, nullptr);
    if (LZ4F_isError(wanted)) refuse("lz4", LZ4F_getErrorName(wanted));
    chunk.bytes.resize(used + made_bytes);
    at += taken;
    more = at < packed.size() || (wanted != 0 && made_bytes == room);
  }
  chunk.whole = wanted == 0;
  return chunk;
}

}  // namespace

std::string compression_name(Compression compression) {
  if (compression == Compression::kNone) return "";
  return compression == Compression::kZstd ? "zstd" : "lz4";
}

std::string pack_chunk(std::string_view bytes, Compression compression) {
  if (compression == Compression::kNone) return std::string(bytes);
  return compression == Compression::kZstd ? pack_zstd(bytes) : pack_lz4(bytes);
}

UnpackedChunk unpack_chunk(std::string_view packed, const std::string& compression,
                           std::uint64_t most) {
  if (compression == "zstd") return unpack_zstd(packed, most);
  if (compression == "lz4") return unpack_lz4(packed, most);
  if (!compression.empty()) {
    throw std::runtime_error(
        fmt::format("its compression '{}' is not known; zstd, lz4 and none are", compression));
  }
  if (packed.size() > most) {
    throw std::runtime_error(fmt::format("it has more than the {} bytes it may have", most));
  }
  return {std::string(packed), true};
}

}  // namespace castaway::testbed
