#include "tools/live/lines/live_line.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {

void LiveLine::say(const nlohmann::ordered_json& json) { send(WireKind::kSaid, json_text(json)); }

void LiveLine::show(const std::string& frame) { send(WireKind::kFrame, frame); }

void LiveLine::send(WireKind kind, const std::string& body) {
  const std::string bytes = to_wire(kind, body);
  std::size_t at = 0;
  while (at < bytes.size()) {
    const ssize_t count = ::send(socket_, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw LineCut{};
    at += static_cast<std::size_t>(count);
  }
}

std::vector<std::string> LiveLine::hear(std::chrono::nanoseconds patience) {
  using std::chrono::milliseconds;
  pollfd file{socket_, POLLIN, 0};
  const auto wait_ms =
      std::chrono::ceil<milliseconds>(std::max(patience, std::chrono::nanoseconds(0))).count();
  std::vector<std::string> commands;
  if (::poll(&file, 1, static_cast<int>(wait_ms)) <= 0) return commands;
  std::array<char, 65536> buffer{};
  const ssize_t count = recv(socket_, buffer.data(), buffer.size(), 0);
  if (count < 0 && errno == EINTR) return commands;
  if (count <= 0) throw LineCut{};
  reader_.take({buffer.data(), static_cast<std::size_t>(count)});
  while (auto message = reader_.next()) commands.push_back(std::move(message->body));
  return commands;
}

}  // namespace castaway::testbed
