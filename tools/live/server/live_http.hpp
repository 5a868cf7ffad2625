/// What the server of a live run answers to requests, other than for the run's stream.
#pragma once

#include <string_view>

#include <boost/beast/http.hpp>

#include "tools/live/server/live_files.hpp"
#include "tools/live/server/live_server.hpp"

namespace castaway::testbed {

using LiveRequest = boost::beast::http::request<boost::beast::http::string_body>;
using LiveResponse = boost::beast::http::response<boost::beast::http::string_body>;

/// Paths: "/" is the page, "/report/3" a report, and "/file?name=map.yaml" takes a file by POST.
class LiveHttp {
 public:
  /// `options` must outlive it.
  explicit LiveHttp(const LiveServerOptions& options) : options_(options), files_(options.files) {}

  /// Why a request to the server at `port` is refused, by its header; nullptr if it is not.
  [[nodiscard]] const char* refusal_of(const LiveRequest& request, std::uint16_t port) const;
  /// The largest body that may follow a header. [bytes]
  [[nodiscard]] static std::uint64_t body_limit(const LiveRequest& request);
  [[nodiscard]] LiveResponse respond(const LiveRequest& request);

  /// A plain text.
  [[nodiscard]] static LiveResponse answer(const LiveRequest& request,
                                           boost::beast::http::status status, std::string body);

 private:
  const LiveServerOptions& options_;
  LiveFiles files_;
};

/// Text of Boost as a view.
inline std::string_view to_view(boost::string_view text) { return {text.data(), text.size()}; }

}  // namespace castaway::testbed
