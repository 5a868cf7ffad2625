#include "tools/formats/volume/packed_bytes.hpp"

#include <zstd.h>

namespace castaway::testbed {
namespace {

constexpr int kLevel = 9;
constexpr unsigned long long kMost = 4ULL << 30U;

}  // namespace

std::string pack_bytes(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

std::string unpack_bytes(std::string_view packed) {
  const auto size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN) {
    throw std::runtime_error("holds no zstd frame; it is damaged");
  }
  constexpr unsigned long long kBest = 20'000;  // zstd packs 100 kB of zeros into some ten bytes.
  if (size > kMost || size / kBest > packed.size()) {
    throw std::runtime_error("states a size that it cannot have; it is damaged");
  }
  std::string bytes(size, '\0');
  const std::size_t unpacked =
      ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(unpacked) != 0 || unpacked != bytes.size()) {
    throw std::runtime_error("is damaged or cut off; make or copy it again");
  }
  return bytes;
}

}  // namespace castaway::testbed
