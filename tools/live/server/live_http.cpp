#include "tools/live/server/live_http.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <boost/beast/websocket.hpp>

#include "tools/base/files/file.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/live/server/live_token.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMostDigits = 6;

bool is_number(std::string_view text) {
  return !text.empty() && text.size() <= kMostDigits &&
         std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

namespace http = boost::beast::http;

constexpr std::string_view kFilePath = "/file";

LiveResponse typed_answer(const LiveRequest& request, http::status status, std::string body,
                          const char* type) {
  LiveResponse response{status, request.version()};
  response.set(http::field::content_type, type);
  response.set(http::field::cache_control, "no-store");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("X-Frame-Options", "DENY");
  response.keep_alive(request.keep_alive());
  response.body() = std::move(body);
  response.prepare_payload();
  return response;
}

LiveResponse page_answer(const LiveRequest& request, std::string page) {
  return typed_answer(request, http::status::ok, std::move(page), "text/html; charset=utf-8");
}

bool brings_file(const LiveRequest& request) {
  return request.method() == http::verb::post && path_of(to_view(request.target())) == kFilePath;
}

}  // namespace

std::string LiveFiles::keep(const std::string& name, std::string_view bytes) {
  if (const std::string error = file_path_error(name); !error.empty()) {
    return "a file's name " + error;
  }
  if (files_ >= limits_.files || bytes_ + bytes.size() > limits_.bytes) {
    return fmt::format("more than {} files or {} MiB: start castaway live again", limits_.files,
                       limits_.bytes >> 20U);
  }
  try {
    std::filesystem::create_directories((folder_ / name).parent_path());
    write_file(folder_ / name, bytes);
  } catch (const std::exception& error) {
    return error.what();
  }
  ++files_;
  bytes_ += bytes.size();
  return "";
}

std::optional<std::string> read_report(std::string_view path,
                                       const std::filesystem::path& reports) {
  constexpr std::string_view kPrefix = "/report/";
  if (!path.starts_with(kPrefix) || !is_number(path.substr(kPrefix.size()))) return std::nullopt;
  const std::filesystem::path file =
      reports / std::string(path.substr(kPrefix.size())) / "report.html";
  if (!std::filesystem::is_regular_file(file)) return std::nullopt;
  try {
    return read_file(file);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

LiveResponse LiveHttp::answer(const LiveRequest& request, http::status status, std::string body) {
  return typed_answer(request, status, std::move(body), "text/plain; charset=utf-8");
}

const char* LiveHttp::refusal_of(const LiveRequest& request, std::uint16_t port) const {
  const std::string_view host = to_view(request[http::field::host]);
  if (!is_own_host(host, port)) return "another host name";
  const std::string_view origin = to_view(request[http::field::origin]);
  const bool acts =
      boost::beast::websocket::is_upgrade(request) || request.method() == http::verb::post;
  if ((acts || !origin.empty()) && !is_own_origin(origin, host)) return "another origin";
  const std::string token = query_value(to_view(request.target()), "token");
  return equal_tokens(token, options_.token) ? nullptr : "no token, or a wrong one";
}

std::uint64_t LiveHttp::body_limit(const LiveRequest& request) {
  return brings_file(request) ? kLargestUpload : 0;
}

LiveResponse LiveHttp::respond(const LiveRequest& request) {
  const std::string_view target = to_view(request.target());
  if (brings_file(request)) {
    const std::string why = files_.keep(decoded_query_value(target, "name"), request.body());
    if (!why.empty()) return answer(request, http::status::bad_request, why + "\n");
    return answer(request, http::status::ok, "kept\n");
  }
  if (request.method() != http::verb::get) {
    return answer(request, http::status::method_not_allowed, "GET only\n");
  }
  if (path_of(target) == "/") return page_answer(request, options_.page);
  if (auto report = read_report(path_of(target), options_.reports)) {
    return page_answer(request, std::move(*report));
  }
  return answer(request, http::status::not_found, "nothing here\n");
}

}  // namespace castaway::testbed
