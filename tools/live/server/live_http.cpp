#include "tools/live/server/live_http.hpp"

#include <utility>

#include <boost/beast/websocket.hpp>

#include "tools/live/server/live_token.hpp"

namespace castaway::testbed {
namespace {

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
