#include "tools/base/formats/points/lzf.hpp"

#include <liblzf/lzf.h>

#include <limits>
#include <utility>

namespace castaway::testbed {
namespace {

constexpr std::size_t kMostBytesPerByte = 88;  // Three bytes announce up to 264.

}  // namespace

std::optional<std::string> decompress_lzf(std::string_view packed, std::size_t size) {
  using Size = unsigned int;
  if (packed.empty() && size == 0) return std::string();
  const bool possible = size > 0 && size <= kMostBytesPerByte * packed.size();
  if (!possible || size > std::numeric_limits<Size>::max()) return std::nullopt;
  std::string text(size, '\0');
  const Size written = lzf_decompress(packed.data(), static_cast<Size>(packed.size()), text.data(),
                                      static_cast<Size>(size));
  return written == size ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace castaway::testbed
