#include "tools/live/server/live_token.hpp"

#include <arpa/inet.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("the system has no random numbers for a token");
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool equal_tokens(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0;
}

std::string_view path_of(std::string_view target) { return target.substr(0, target.find('?')); }

std::string query_value(std::string_view target, std::string_view key) {
  const std::size_t begin = target.find('?');
  if (begin == std::string_view::npos) return "";
  std::string_view rest = target.substr(begin + 1);
  while (!rest.empty()) {
    const std::string_view pair = rest.substr(0, rest.find('&'));
    if (pair.size() > key.size() && pair.starts_with(key) && pair[key.size()] == '=') {
      return std::string(pair.substr(key.size() + 1));
    }
    rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
  }
  return "";
}

std::string decoded_query_value(std::string_view target, std::string_view key) {
  const std::string text = query_value(target, key);
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    const char* digits = text.data() + i + 1;
    const bool is_code = text[i] == '%' && i + 2 < text.size() &&
                         std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    decoded += is_code ? static_cast<char>(code) : text[i] == '+' ? ' ' : text[i];
    if (is_code) i += 2;
  }
  return decoded;
}

bool is_own_host(std::string_view host, unsigned port) {
  const std::string at_port = fmt::format(":{}", port);
  if (!host.ends_with(at_port)) return false;
  host.remove_suffix(at_port.size());
  if (host == "localhost") return true;
  const bool v6 = host.starts_with('[') && host.ends_with(']');
  const std::string address(v6 ? host.substr(1, host.size() - 2) : host);
  std::array<unsigned char, sizeof(in6_addr)> parsed{};
  return inet_pton(v6 ? AF_INET6 : AF_INET, address.c_str(), parsed.data()) == 1;
}

bool is_own_origin(std::string_view origin, std::string_view host) {
  return origin == fmt::format("http://{}", host);
}

}  // namespace castaway::testbed
