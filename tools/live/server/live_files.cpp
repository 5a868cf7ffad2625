#include "tools/live/server/live_files.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/base/output/file_name.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMostDigits = 6;

bool is_number(std::string_view text) {
  return !text.empty() && text.size() <= kMostDigits &&
         std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
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

}  // namespace castaway::testbed
