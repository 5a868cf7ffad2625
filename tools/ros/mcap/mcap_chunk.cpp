#include "tools/ros/mcap/mcap_chunk.hpp"

#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>
#include <zlib.h>

#include "tools/base/bytes/byte_reader.hpp"
#include "tools/base/bytes/compression.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint64_t kMostOfChunk = 256ULL << 20;

std::uint32_t checksum(std::string_view bytes) {
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(0, data, bytes.size()));
}

}  // namespace

std::string open_chunk(std::string_view content, bool whole) {
  ByteReader record(content);
  record.take(2 * sizeof(std::uint64_t));  // Start and end time.
  const auto size = record.number<std::uint64_t>();
  const auto crc = record.number<std::uint32_t>();
  const std::string compression = record.text();
  const auto packed_size = record.number<std::uint64_t>();
  const std::string_view packed = record.take(whole ? packed_size : record.rest());
  if (size > kMostOfChunk) {
    throw std::runtime_error(
        fmt::format("a chunk claims {} bytes; at most {} are read", size, kMostOfChunk));
  }
  UnpackedChunk chunk = unpack_chunk(packed, compression, size);
  if (!whole) return std::move(chunk.bytes);
  if (!chunk.whole || chunk.bytes.size() != size) {
    throw std::runtime_error(
        fmt::format("a chunk claims {} bytes and holds {}", size, chunk.bytes.size()));
  }
  if (crc != 0 && checksum(chunk.bytes) != crc) {
    throw std::runtime_error("a chunk is damaged: its checksum does not fit");
  }
  return std::move(chunk.bytes);
}

}  // namespace castaway::testbed
