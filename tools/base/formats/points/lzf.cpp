#include "tools/base/formats/points/lzf.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace castaway::testbed {
namespace {

constexpr std::size_t kLiteralEnd = 32;        // Lower control bytes announce literals.
constexpr std::size_t kLongMatch = 7;          // A further byte of length follows.
constexpr std::size_t kMostBytesPerByte = 88;  // Three bytes announce up to 264.

/// Takes runs from the front of LZF data and appends what they stand for.
class LzfRuns {
 public:
  LzfRuns(std::string_view packed, std::size_t size) : rest_(packed) {
    text_.reserve(std::min(size, kMostBytesPerByte * packed.size()));
  }

  /// Takes one run; false if it is damaged.
  bool take() {
    const std::size_t control = byte();
    return control < kLiteralEnd ? take_literals(control + 1) : take_match(control);
  }
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  std::string& text() { return text_; }

 private:
  std::size_t byte() {
    const auto value = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return value;
  }

  bool take_literals(std::size_t size) {
    if (rest_.size() < size) return false;
    text_.append(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return true;
  }

  /// Repeats earlier bytes, which may overlap those that are appended.
  bool take_match(std::size_t control) {
    const bool is_long = control >> 5U == kLongMatch;
    if (rest_.size() < (is_long ? 2 : 1)) return false;
    const std::size_t length = (control >> 5U) + 2 + (is_long ? byte() : 0);
    const std::size_t back = ((control & 31U) << 8U) + byte() + 1;
    if (back > text_.size()) return false;
    for (std::size_t i = 0; i < length; ++i) text_ += text_[text_.size() - back];
    return true;
  }

  std::string_view rest_;
  std::string text_;
};

}  // namespace

std::optional<std::string> decompress_lzf(std::string_view packed, std::size_t size) {
  LzfRuns runs(packed, size);
  while (!runs.empty()) {
    if (!runs.take() || runs.text().size() > size) return std::nullopt;
  }
  if (runs.text().size() != size) return std::nullopt;
  return std::move(runs.text());
}

}  // namespace castaway::testbed
