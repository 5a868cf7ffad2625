#include "tools/formats/volume/octomap_check.hpp"

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace castaway::testbed {
namespace {

constexpr std::string_view kBinaryHead = "# Octomap OcTree binary file";
constexpr std::string_view kFullHead = "# Octomap OcTree file";
constexpr std::string_view kData = "\ndata\n";
constexpr int kDepth = 16;

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw std::runtime_error(name + ": " + what);
}

/// Children of a node in a binary file: two bits each, 3: the child has children of its own.
int inner_children(std::uint8_t low, std::uint8_t high) {
  const unsigned bits = static_cast<unsigned>(low) | static_cast<unsigned>(high) << 8U;
  int inner = 0;
  for (unsigned child = 0; child < 8; ++child) inner += (bits >> (2 * child) & 3U) == 3U ? 1 : 0;
  return inner;
}

/// Children of a node in a full file, a bit each.
int children(std::uint8_t bits) { return __builtin_popcount(bits); }

/// Walks over the nodes, depth first. `node` [bytes]: size of one; its last bytes say how many
/// children follow.
void check_nodes(std::string_view nodes, OctomapKind kind, const std::string& name) {
  const std::size_t size = kind == OctomapKind::kBinary ? 2 : 5;
  std::vector<int> open{1};  // Nodes still to come, by depth.
  std::size_t at = 0;
  while (!open.empty()) {
    if (open.back() == 0) {
      open.pop_back();
      continue;
    }
    --open.back();
    if (nodes.size() - at < size) fail(name, "the tree is cut off; copy the file again");
    const auto last = static_cast<std::uint8_t>(nodes[at + size - 1]);
    const int below = kind == OctomapKind::kBinary
                          ? inner_children(static_cast<std::uint8_t>(nodes[at]), last)
                          : children(last);
    at += size;
    open.push_back(below);
    if (std::cmp_greater(open.size(), kDepth + 1)) {
      fail(name, "the tree is deeper than 16 levels; the file is damaged");
    }
  }
}

}  // namespace

OctomapKind octomap_kind(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with(kBinaryHead)) return OctomapKind::kBinary;
  if (bytes.starts_with(kFullHead)) return OctomapKind::kFull;
  fail(name, "is no OctoMap file: it does not begin with '# Octomap OcTree'");
}

void check_octomap(std::string_view bytes, const std::string& name) {
  const OctomapKind kind = octomap_kind(bytes, name);
  const std::size_t data = bytes.substr(0, 4096).find(kData);
  if (data == std::string_view::npos) fail(name, "has no line 'data' in its first 4 kB");
  const std::string_view head = bytes.substr(0, data + 1);
  const std::size_t id = head.find("\nid ");
  if (id == std::string_view::npos || !head.substr(id + 4).starts_with("OcTree\n")) {
    fail(name, "holds no tree of occupancies; convert it to one (id OcTree)");
  }
  const std::size_t size = head.find("\nsize ");
  if (size != std::string_view::npos && head.substr(size + 6).starts_with("0\n")) return;
  check_nodes(bytes.substr(data + kData.size()), kind, name);
}

}  // namespace castaway::testbed
