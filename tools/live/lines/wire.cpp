#include "tools/live/lines/wire.hpp"

#include <cstring>
#include <stdexcept>

namespace castaway::testbed {
namespace {

/// Before the body; both ends are on one machine.
struct WireHead {
  std::uint32_t size = 0;
  std::uint32_t kind = 0;
};

}  // namespace

std::string to_wire(WireKind kind, std::string_view body) {
  const WireHead head{static_cast<std::uint32_t>(body.size()), static_cast<std::uint32_t>(kind)};
  std::string bytes(sizeof head + body.size(), '\0');
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + sizeof head, body.data(), body.size());
  return bytes;
}

/// Once for each message that is cut, or for all that are read, not for each that is read.
void WireReader::drop_read() {
  bytes_.erase(0, read_);
  read_ = 0;
}

std::optional<WireMessage> WireReader::next() {
  WireHead head;
  if (bytes_.size() - read_ < sizeof head) {
    drop_read();
    return std::nullopt;
  }
  std::memcpy(&head, bytes_.data() + read_, sizeof head);
  if (head.size > kLongest || head.kind < 1 || head.kind > 3) {
    throw std::runtime_error("not a message between server and run");
  }
  if (bytes_.size() - read_ < sizeof head + head.size) {
    drop_read();
    return std::nullopt;
  }
  WireMessage message{static_cast<WireKind>(head.kind),
                      bytes_.substr(read_ + sizeof head, head.size)};
  read_ += sizeof head + head.size;
  return message;
}

}  // namespace castaway::testbed
