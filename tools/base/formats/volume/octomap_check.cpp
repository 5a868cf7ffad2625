#include "tools/base/formats/volume/octomap_check.hpp"

#include <charconv>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace castaway::testbed {
namespace {

constexpr std::string_view kBinaryHead = "# Octomap OcTree binary file";
constexpr std::string_view kFullHead = "# Octomap OcTree file";
constexpr std::string_view kData = "\ndata\n";
constexpr int kDepth = 16;

[[noreturn]] void refuse_octomap(const std::string& name, const std::string& what) {
  throw std::runtime_error(name + ": " + what);
}

/// The word after a key at the beginning of a line; empty if there is none.
std::string_view value_of(std::string_view lines, const std::string& key) {
  const std::size_t at = lines.find("\n" + key + " ");
  if (at == std::string_view::npos) return {};
  const std::string_view value = lines.substr(at + key.size() + 2);
  return value.substr(0, value.find_first_of(" \r\n"));
}

template <typename Number>
std::optional<Number> number_of(std::string_view lines, const std::string& key) {
  const std::string_view text = value_of(lines, key);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
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
    if (nodes.size() - at < size) refuse_octomap(name, "the tree is cut off; copy the file again");
    const auto last = static_cast<std::uint8_t>(nodes[at + size - 1]);
    const int below = kind == OctomapKind::kBinary
                          ? inner_children(static_cast<std::uint8_t>(nodes[at]), last)
                          : children(last);
    at += size;
    open.push_back(below);
    if (below > 0 && std::cmp_greater(open.size(), kDepth + 1)) {
      refuse_octomap(name, "the tree is deeper than 16 levels; the file is damaged");
    }
  }
}

}  // namespace

OctomapKind octomap_kind(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with(kBinaryHead)) return OctomapKind::kBinary;
  if (bytes.starts_with(kFullHead)) return OctomapKind::kFull;
  refuse_octomap(name, "is no OctoMap file: it does not begin with '# Octomap OcTree'");
}

OctomapHead check_octomap(std::string_view bytes, const std::string& name) {
  OctomapHead head;
  head.kind = octomap_kind(bytes, name);
  const std::size_t data = bytes.substr(0, 4096).find(kData);
  if (data == std::string_view::npos) refuse_octomap(name, "has no line 'data' in its first 4 kB");
  const std::string_view lines = bytes.substr(0, data + 1);
  if (value_of(lines, "id") != "OcTree") {
    refuse_octomap(name, "holds no tree of occupancies; convert it to one (id OcTree)");
  }
  head.resolution = number_of<double>(lines, "res").value_or(0.0);
  if (!(head.resolution >= 0.001 && head.resolution <= 100.0)) {
    refuse_octomap(name, "its line 'res' states no edge of 1 mm to 100 m");
  }
  const auto nodes = number_of<std::size_t>(lines, "size");
  if (!nodes) refuse_octomap(name, "its line 'size' states no number of nodes");
  head.nodes = *nodes;
  head.data = data + kData.size();
  if (head.nodes > 0) check_nodes(bytes.substr(head.data), head.kind, name);
  return head;
}

}  // namespace castaway::testbed
