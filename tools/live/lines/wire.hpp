/// Messages between the process that serves pages and the process that plays the run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// What a message is.
enum class WireKind : std::uint8_t {
  kCommand = 1,  ///< To the run: JSON of a hand.
  kSaid = 2,     ///< From the run: JSON for every page, never dropped.
  kFrame = 3,    ///< From the run: a frame (`live_feed.hpp`); a slow page misses some.
};

/// A message.
struct WireMessage {
  WireKind kind = WireKind::kCommand;
  std::string body;
};

/// Length and kind, then the body.
std::string to_wire(WireKind kind, std::string_view body);

/// Takes messages out of a stream of bytes.
class WireReader {
 public:
  /// Longer messages are refused.
  static constexpr std::size_t kLongest = std::size_t{64} << 20U;

  void take(std::string_view bytes) { bytes_.append(bytes); }
  /// The next whole message; nothing if it has not arrived. Throws std::runtime_error if the stream
  /// is none of messages.
  std::optional<WireMessage> next();

  /// Bytes that it holds.
  [[nodiscard]] std::size_t held() const { return bytes_.size(); }

 private:
  void drop_read();

  std::string bytes_;
  std::size_t read_ = 0;
};

}  // namespace castaway::testbed
