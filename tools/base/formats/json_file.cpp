#include "tools/base/formats/json_file.hpp"

#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {

bool nests_too_deep(std::string_view json) {
  constexpr int kMostDepth = 100;
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text && c == '\\') ++i;
    if (c == '"') in_text = !in_text;
    if (in_text) continue;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > kMostDepth) return true;
  }
  return false;
}

nlohmann::ordered_json read_json(const std::filesystem::path& path) {
  constexpr std::uintmax_t kMost = std::uintmax_t{64} << 20U;
  const std::string text = read_file(path, kMost);
  if (nests_too_deep(text)) {
    throw std::runtime_error(path.string() +
                             ": JSON nested more than 100 deep; castaway writes no such file");
  }
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::ordered_json::exception& error) {
    throw std::runtime_error(path.string() + ": broken JSON, run it again: " + error.what());
  }
}

void read_fields(const std::filesystem::path& path, const std::function<void()>& read) {
  try {
    read();
  } catch (const nlohmann::json::exception& error) {
    std::string what = error.what();  // "[json.exception.type_error.302] type must be ..."
    what.erase(0, what.find("] ") + 2);
    throw std::runtime_error(path.string() + ": damaged, or not castaway's: " + what +
                             "; run it again");
  }
}

}  // namespace castaway::testbed
