/// What the server of a live run answers to requests, other than for the run's stream.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <boost/beast/http.hpp>

#include "tools/live/server/live_server.hpp"

namespace castaway::testbed {

/// Limits of what pages bring, together.
struct FileLimits {
  std::uint64_t bytes = std::uint64_t{256} << 20U;
  std::size_t files = 2000;
};

/// The largest file that a page may bring. [bytes]
inline constexpr std::uint64_t kLargestUpload = std::uint64_t{64} << 20U;

/// Keeps files in a folder of its own, which it makes for the first of them.
class LiveFiles {
 public:
  explicit LiveFiles(std::filesystem::path folder, FileLimits limits = {})
      : folder_(std::move(folder)), limits_(limits) {}

  /// Keeps a file, `name` being its path with slashes; one of the same name is replaced. Returns
  /// why it cannot, or an empty text.
  std::string keep(const std::string& name, std::string_view bytes);

 private:
  std::filesystem::path folder_;
  FileLimits limits_;
  std::uint64_t bytes_ = 0;  ///< Taken so far, also by files that were replaced.
  std::size_t files_ = 0;
};

/// The report at the path "/report/NUMBER" of a request, in the folder `reports`; nothing if there
/// is none.
std::optional<std::string> read_report(std::string_view path, const std::filesystem::path& reports);

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
