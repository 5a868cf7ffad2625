#include "tools/scenario/yaml/yaml_reader.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/scenario/yaml/nearest.hpp"
#include "xacro/files/nearest_name.hpp"

namespace castaway::testbed {
namespace {

using Kind = YamlNode::Kind;

std::vector<std::string> keys_of(const YamlNode& map) {
  std::vector<std::string> keys;
  for (const YamlEntry& entry : map.entries) keys.push_back(entry.key);
  return keys;
}

void mark_known(YamlNode& node) {
  node.known = keys_of(node);
  for (YamlEntry& entry : node.entries) mark_known(entry.value);
  for (YamlNode& item : node.items) mark_known(item);
}

void forget_known(YamlNode& node) {
  node.known.clear();
  for (YamlEntry& entry : node.entries) forget_known(entry.value);
  for (YamlNode& item : node.items) forget_known(item);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A list of scalars is a value; maps and lists of maps have keys to check.
void reject_unknown(const YamlNode& node) {
  for (const YamlEntry& entry : node.entries) {
    if (!contains(node.known, entry.key)) {
      throw std::runtime_error(fmt::format("{}: unknown key '{}'; {}", entry.value.where, entry.key,
                                           suggestion(entry.key, node.known)));
    }
    reject_unknown(entry.value);
  }
  for (const YamlNode& item : node.items) reject_unknown(item);
}

}  // namespace

std::string YamlReader::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void YamlReader::fail(const std::string& message) const {
  const std::string place = node_->where.empty() ? "" : node_->where + ": ";
  const std::string key = path_.empty() ? "" : path_ + ": ";
  throw std::runtime_error(place + key + message);
}

void YamlReader::expect_map() {
  if (is_null()) node_->kind = Kind::kMap;
  if (!is_map()) fail("expected a map of keys and values");
}

std::optional<YamlReader> YamlReader::find(const std::string& key) {
  expect_map();
  if (!contains(node_->known, key)) node_->known.push_back(key);
  YamlNode* found = node_->find(key);
  if (found == nullptr || found->kind == Kind::kNull) return std::nullopt;
  return YamlReader(*found, path_of(key));
}

YamlReader YamlReader::child(const std::string& key) {
  if (!find(key)) fill(key, {});
  YamlReader reader(*node_->find(key), path_of(key));
  reader.expect_map();
  return reader;
}

std::vector<YamlReader> YamlReader::list(const std::string& key) {
  const auto found = find(key);
  return found ? found->items() : std::vector<YamlReader>{};
}

YamlNode YamlReader::raw() const {
  mark_known(*node_);
  return copy();
}

YamlNode YamlReader::copy() const {
  YamlNode copy = *node_;
  forget_known(copy);
  return copy;
}

std::vector<YamlReader> YamlReader::items() const {
  if (!is_list()) fail("expected a list");
  std::vector<YamlReader> readers;
  for (YamlNode& item : node_->items) {
    readers.emplace_back(item, fmt::format("{}[{}]", path_, readers.size()));
  }
  return readers;
}

std::vector<std::pair<std::string, YamlReader>> YamlReader::entries() {
  expect_map();
  std::vector<std::pair<std::string, YamlReader>> result;
  for (YamlEntry& entry : node_->entries) {
    if (!contains(node_->known, entry.key)) node_->known.push_back(entry.key);
    result.emplace_back(entry.key, YamlReader(entry.value, path_of(entry.key)));
  }
  return result;
}

std::pair<std::string, YamlReader> YamlReader::name_and_body() {
  if (is_scalar()) {
    node_->entries.push_back({node_->scalar, {}});
    node_->entries.back().value.where = node_->where;
    node_->kind = Kind::kMap;
    node_->scalar.clear();
  }
  if (!is_map() || node_->entries.size() != 1) {
    fail("expected a name, or a name with its settings (`name: {key: value}`)");
  }
  auto entry = entries().front();
  entry.second.expect_map();
  return entry;
}

std::string YamlReader::choice(const std::string& key, const std::string& fallback,
                               const std::vector<std::string>& allowed) {
  std::string value = get(key, fallback);
  if (!contains(allowed, value)) {
    find(key)->fail(fmt::format("'{}' is not allowed here; {}", value, suggestion(value, allowed)));
  }
  return value;
}

YamlReader YamlReader::required(const std::string& key) {
  if (const auto found = find(key)) return *found;
  std::vector<std::string> unread = keys_of(*node_);
  std::erase_if(unread, [&](const auto& name) { return contains(node_->known, name); });
  const auto near = nearest_name(key, unread);
  fail(fmt::format("needs the key '{}'{}", key,
                   near ? fmt::format("; is '{}' meant to be it?", *near) : ""));
}

void YamlReader::fill(const std::string& key, YamlNode value) {
  value.where = node_->where;
  if (YamlNode* found = node_->find(key)) {
    *found = std::move(value);
  } else {
    node_->entries.push_back({key, std::move(value)});
  }
}

YamlDocument YamlDocument::load(const std::filesystem::path& file) {
  return parse(read_file(file, kLargestSettings), file.string());
}

YamlDocument YamlDocument::parse(const std::string& text, const std::string& name) {
  return YamlDocument(parse_yaml(text, name));
}

void YamlDocument::reject_unknown_keys() const { reject_unknown(*root_); }

}  // namespace castaway::testbed
