#include "tools/run/foreign_config.hpp"

namespace castaway::testbed {

std::string find_beside(const std::string& text, const std::filesystem::path& folder) {
  std::error_code ignored;
  const std::filesystem::path beside = folder / text;
  const bool is_beside = !text.empty() && !std::filesystem::exists(text, ignored) &&
                         std::filesystem::is_regular_file(beside, ignored);
  return is_beside ? beside.string() : text;
}

}  // namespace castaway::testbed
