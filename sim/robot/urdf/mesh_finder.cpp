#include "sim/robot/urdf/mesh_finder.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

/// The text after `prefix`; nothing if `uri` does not start with it.
std::optional<std::string> after(const std::string& uri, const std::string& prefix) {
  if (!uri.starts_with(prefix)) return std::nullopt;
  return uri.substr(prefix.size());
}

}  // namespace

std::optional<std::string> MeshFinder::find(const std::string& uri) const {
  if (const auto rest = after(uri, "package://")) return in_package(*rest);
  if (const auto rest = after(uri, "model://")) return in_package(*rest);
  const std::string path = after(uri, "file://").value_or(uri);
  if (const std::size_t scheme = path.find("://"); scheme != std::string::npos) {
    throw std::runtime_error(fmt::format(
        "{}: the scheme {}:// is not known: use package://, model://, file:// or a path", uri,
        path.substr(0, scheme)));
  }
  return fs::path(path).is_absolute() ? if_file(path) : relative(path);
}

std::optional<std::string> MeshFinder::if_file(const fs::path& path) const {
  const fs::path normal = path.lexically_normal();
  if (!packages_->may_read(normal)) throw std::runtime_error(packages_->refusal(normal));
  std::error_code ignored;
  if (!fs::is_regular_file(normal, ignored)) return std::nullopt;
  return normal.string();
}

std::optional<std::string> MeshFinder::in_package(const std::string& package_path) const {
  const std::size_t slash = package_path.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto folder = packages_->find(package_path.substr(0, slash));
  if (!folder) return std::nullopt;
  return if_file(*folder / package_path.substr(slash + 1));
}

/// A forbidden place is an error only if the file is at no allowed place.
std::optional<std::string> MeshFinder::relative(const std::string& path) const {
  std::optional<fs::path> refused;
  for (const fs::path& start : packages_->starts()) {
    if (!packages_->may_read(start / path)) {
      if (!refused) refused = start / path;
    } else if (auto file = if_file(start / path)) {
      return file;
    }
  }
  if (refused) throw std::runtime_error(packages_->refusal(*refused));
  return std::nullopt;
}

}  // namespace castaway::sim
