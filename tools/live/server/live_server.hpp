/// Serves the page of a live run and the run's stream.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace castaway::testbed {

/// Where it listens, and what it serves.
struct LiveServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;  ///< 0: any free one.
  std::string token;
  std::string page;                 ///< HTML of "/".
  std::filesystem::path files{};    ///< Folder for what pages bring; it is made when needed.
  std::filesystem::path reports{};  ///< Folder of the reports "/report/1", "/report/2"...
};

/// Serves pages in this thread: HTTP, and a WebSocket at "/live". A request without the token, from
/// another host name or from another origin is refused. Pages share one run, whose process is at
/// the other end of a socket (`wire.hpp`); it is never kept waiting by a page.
class LiveServer {
 public:
  /// Listens. Throws std::runtime_error if it cannot: the port is taken, or the address is none of
  /// this machine.
  LiveServer(LiveServerOptions options, int run_socket);
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  /// "http://127.0.0.1:8080/?token=..."
  [[nodiscard]] std::string url() const;
  /// Serves until SIGINT or SIGTERM, or until the run ends. `log` gets a line for everything that
  /// is refused. Returns true if the run ended by itself.
  bool serve(const std::function<void(const std::string&)>& log);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace castaway::testbed
