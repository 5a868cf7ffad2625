#include "tools/base/output/file_name.hpp"

#include <algorithm>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMaxBytes = 100;

bool is_allowed(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 && byte != 0x7f && c != '/' && c != '\\';
}

}  // namespace

std::string file_name_error(std::string_view name) {
  if (name.empty()) return "must not be empty";
  if (name.size() > kMaxBytes) return "must not be longer than 100 bytes";
  if (name.front() == '.' || name.front() == '-') {
    return std::string("must not begin with '") + name.front() + "'";
  }
  if (name.front() == ' ' || name.back() == ' ') return "must not begin or end with a blank";
  if (find_invalid_utf8(name)) return "must be UTF-8";
  for (const char c : name) {
    if (is_allowed(c)) continue;
    const bool visible = c == '/' || c == '\\';
    return visible ? std::string("must not hold '") + c + "'; it names files, it is not a path"
                   : std::string("must not hold control characters");
  }
  return "";
}

std::string file_path_error(std::string_view path) {
  constexpr int kMostParts = 12;
  for (int part = 0; part < kMostParts; ++part) {
    const std::size_t slash = path.find('/');
    if (std::string error = file_name_error(path.substr(0, slash)); !error.empty()) return error;
    if (slash == std::string_view::npos) return "";
    path.remove_prefix(slash + 1);
  }
  return "must not lie in so many folders";
}

std::string file_name_of(std::string_view text) {
  std::string name(text.substr(0, kMaxBytes));
  while (const auto invalid = find_invalid_utf8(name)) name[*invalid] = '_';
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_allowed(c); }, '_');
  if (name.empty()) return "unnamed";
  for (const std::size_t i : {std::size_t{0}, name.size() - 1}) {
    const bool leading = i == 0 && (name[i] == '.' || name[i] == '-');
    if (leading || name[i] == ' ') name[i] = '_';
  }
  return name;
}

}  // namespace castaway::testbed
