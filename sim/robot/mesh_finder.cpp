#include "sim/robot/mesh_finder.hpp"

#include <tinyxml.h>

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> if_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  return fs::weakly_canonical(path).string();
}

/// The name in the folder's package.xml, empty if there is none.
std::string package_name(const fs::path& folder) {
  TiXmlDocument document((folder / "package.xml").string());
  if (!document.LoadFile() || document.RootElement() == nullptr) return "";
  const TiXmlElement* name = document.RootElement()->FirstChildElement("name");
  return name == nullptr || name->GetText() == nullptr ? "" : name->GetText();
}

/// The text behind `prefix`; nothing if `uri` does not start with it.
std::optional<std::string> after(const std::string& uri, const std::string& prefix) {
  if (!uri.starts_with(prefix)) return std::nullopt;
  return uri.substr(prefix.size());
}

}  // namespace

MeshFinder::MeshFinder(const std::string& urdf_path, const std::vector<std::string>& search_paths) {
  for (fs::path folder = fs::absolute(urdf_path).parent_path();; folder = folder.parent_path()) {
    ancestors_.push_back(folder);
    if (folder == folder.parent_path()) break;
  }
  for (const std::string& path : search_paths) ancestors_.push_back(fs::absolute(path));
}

std::optional<std::string> MeshFinder::find(const std::string& uri) const {
  if (const auto rest = after(uri, "package://")) return find_in_package(*rest);
  if (const auto rest = after(uri, "model://")) return find_in_package(*rest);
  if (const auto rest = after(uri, "file://")) return if_file(*rest);
  if (fs::path(uri).is_absolute()) return if_file(uri);
  for (const fs::path& folder : ancestors_) {
    if (auto file = if_file(folder / uri)) return file;
  }
  return std::nullopt;
}

std::optional<std::string> MeshFinder::find_in_package(const std::string& package_path) const {
  const std::size_t slash = package_path.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const std::string package = package_path.substr(0, slash);
  const std::string rest = package_path.substr(slash + 1);
  for (const fs::path& folder : ancestors_) {
    if (folder.filename() == package || package_name(folder) == package) {
      if (auto file = if_file(folder / rest)) return file;
    }
    if (auto file = if_file(folder / package / rest)) return file;
  }
  return std::nullopt;
}

}  // namespace castaway::sim
