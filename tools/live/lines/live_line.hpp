/// The line from the process of a live run to the one that serves pages.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/live/lines/wire.hpp"

namespace castaway::testbed {

/// Thrown when the other end is closed: the run is to end.
struct LineCut {};

/// Messages over a socket (`wire.hpp`). All calls may throw LineCut.
class LiveLine {
 public:
  explicit LiveLine(int socket) : socket_(socket) {}

  /// Says something to every page.
  void say(const nlohmann::ordered_json& json);
  /// The same as text.
  void say_text(const std::string& json) { send(WireKind::kSaid, json); }
  void show(const std::string& frame);
  /// Commands, for which it waits at most this long.
  std::vector<std::string> hear(std::chrono::nanoseconds patience);
  [[nodiscard]] int socket() const { return socket_; }

 private:
  void send(WireKind kind, const std::string& body);

  int socket_;
  WireReader reader_;
};

}  // namespace castaway::testbed
