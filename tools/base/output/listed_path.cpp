#include "tools/base/output/listed_path.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

std::string part_error(std::string_view part) {
  if (part.empty()) return "has an empty part";
  if (part == "." || part == "..") return "leads out of its folder or back into it";
  if (part.find('\0') != std::string_view::npos) return "holds a zero byte";
  return "";
}

}  // namespace

std::string listed_path_error(std::string_view path) {
  if (path.starts_with('/')) return "is absolute";
  while (true) {
    const std::size_t slash = path.find('/');
    if (std::string error = part_error(path.substr(0, slash)); !error.empty()) return error;
    if (slash == std::string_view::npos) return "";
    path.remove_prefix(slash + 1);
  }
}

void require_listed_path(const fs::path& list, std::string_view path) {
  const std::string error = listed_path_error(path);
  if (error.empty()) return;
  throw std::runtime_error(fmt::format(
      "{}: lists the path '{}', which {}; castaway writes no such list, choose another folder",
      list.string(), path, error));
}

std::optional<fs::path> find_link(const fs::path& folder, const fs::path& path) {
  std::error_code none;
  fs::path place = folder;
  for (const fs::path& part : path) {
    place /= part;
    if (fs::is_symlink(fs::symlink_status(place, none))) return place;
  }
  return std::nullopt;
}

void require_no_link(const fs::path& folder, const fs::path& path) {
  const std::optional<fs::path> link = find_link(folder, path);
  if (!link) return;
  throw std::runtime_error(link->string() +
                           ": is a link, which castaway does not follow here; remove it or "
                           "choose another folder with --out");
}

bool is_folder_below(const fs::path& folder, const fs::path& path) {
  std::error_code none;
  fs::path place = folder;
  for (const fs::path& part : path) {
    place /= part;
    if (fs::symlink_status(place, none).type() != fs::file_type::directory) return false;
  }
  return true;
}

}  // namespace castaway::testbed
