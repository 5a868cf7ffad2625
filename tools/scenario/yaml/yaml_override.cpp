#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {
namespace {

using Kind = YamlNode::Kind;

std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = path.find('.'); end != std::string::npos; end = path.find('.', begin)) {
    parts.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(path.substr(begin));
  return parts;
}

YamlNode& list_element(YamlNode& list, const std::string& part, const std::string& where) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
  const bool is_index = error == std::errc{} && end == part.data() + part.size();
  if (!is_index || index > list.items.size()) {
    throw std::invalid_argument(fmt::format("{}: '{}' is no index of a list of {}; use 0 to {}",
                                            where, part, list.items.size(), list.items.size()));
  }
  if (index == list.items.size()) list.items.emplace_back();
  return *std::next(list.items.begin(), static_cast<std::ptrdiff_t>(index));
}

/// The child of `node` named `part`, created if missing. A scalar is replaced by a map; a scalar
/// equal to `part` (`- amcl`) becomes its key. A null value becomes a list if `part` is 0.
YamlNode& child(YamlNode& node, const std::string& part, const std::string& where) {
  if (node.kind == Kind::kNull && part == "0") node.kind = Kind::kList;
  if (node.kind == Kind::kList) return list_element(node, part, where);
  if (node.kind != Kind::kMap) {
    node.kind = Kind::kMap;
    node.scalar.clear();
    node.where = where;
  }
  if (YamlNode* found = node.find(part)) return *found;
  node.entries.push_back({part, {}});
  node.entries.back().value.where = where;
  return node.entries.back().value;
}

void set_place(YamlNode& node, const std::string& where) {
  node.where = where;
  for (YamlNode& item : node.items) set_place(item, where);
  for (YamlEntry& entry : node.entries) set_place(entry.value, where);
}

void mark_override(YamlNode& node) {
  node.is_override = true;
  for (YamlNode& item : node.items) mark_override(item);
  for (YamlEntry& entry : node.entries) mark_override(entry.value);
}

}  // namespace

void apply_override(YamlNode& root, const std::string& assignment) {
  const std::string where = "--set " + assignment;
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw std::invalid_argument(where + ": write it as key=value, e.g. lidar.rate_hz=10");
  }
  YamlNode value = parse_yaml(assignment.substr(equals + 1), where);
  mark_override(value);
  put_value(root, assignment.substr(0, equals), std::move(value), where);
}

void put_value(YamlNode& root, const std::string& path, YamlNode value, const std::string& where) {
  set_place(value, where);
  YamlNode* node = &root;
  for (const std::string& part : split_path(path)) {
    if (part.empty()) throw std::invalid_argument(where + ": an empty key between two dots");
    node = &child(*node, part, where);
  }
  *node = std::move(value);
}

void expand_short_form(YamlNode& root, const std::string& key, const std::string& long_key) {
  YamlNode* node = root.find(key);
  if (node == nullptr || node->kind != YamlNode::Kind::kScalar) return;
  YamlNode map;
  map.kind = YamlNode::Kind::kMap;
  map.where = node->where;
  map.entries.push_back({long_key, std::move(*node)});
  *node = std::move(map);
}

}  // namespace castaway::testbed
