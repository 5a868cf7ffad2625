#include "tools/outputs/records/snapshot_feed.hpp"

#include <charconv>
#include <optional>

#include "castaway/stamp.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

/// Parses stamp and view from a picture's file name without extension.
std::optional<Snapshot> parse_name(const std::string& stem) {
  const std::size_t dash = stem.rfind('-');
  if (stem.empty() || stem[0] != 't' || dash == std::string::npos) return std::nullopt;
  double seconds = 0.0;
  const auto result = std::from_chars(stem.data() + 1, stem.data() + stem.size(), seconds);
  if (result.ec != std::errc{} || *result.ptr != '-') return std::nullopt;
  return Snapshot{localization::from_seconds(seconds), stem.substr(dash + 1), ""};
}

}  // namespace

std::vector<Snapshot> SnapshotFeed::take_new() {
  std::set<std::string> names;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, missing)) {
    if (entry.path().extension() == ".png") names.insert(entry.path().filename().string());
  }
  std::vector<Snapshot> fresh;
  for (const std::string& name : names) {
    if (!seen_.insert(name).second) continue;
    std::optional<Snapshot> snapshot = parse_name(std::filesystem::path(name).stem().string());
    if (!snapshot) continue;
    snapshot->png = read_file(folder_ / name);
    fresh.push_back(std::move(*snapshot));
  }
  return fresh;
}

}  // namespace castaway::testbed
