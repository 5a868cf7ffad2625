#include "tools/scenario/yaml/yaml_tree.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {
namespace {

constexpr int kMaxDepth = 50;            // Aliases can make a tree endlessly deep.
constexpr std::size_t kPerByte = 4;      // Aliases can make it exponentially large; without them
constexpr std::size_t kAlways = 10'000;  // there are fewer nodes than bytes.

class Converter {
 public:
  Converter(std::string name, std::size_t bytes)
      : name_(std::move(name)), most_(kAlways + kPerByte * bytes) {}

  YamlNode convert(const YAML::Node& source, int depth = 0) {
    YamlNode node;
    node.where = fmt::format("{}:{}", name_, source.Mark().line + 1);
    if (depth > kMaxDepth || ++count_ > most_) {
      throw std::runtime_error(node.where + ": nested too deep or too large; check the aliases");
    }
    if (source.IsScalar()) {
      node.kind = YamlNode::Kind::kScalar;
      node.scalar = source.Scalar();
    } else if (source.IsSequence()) {
      node.kind = YamlNode::Kind::kList;
      for (const YAML::Node& item : source) node.items.push_back(convert(item, depth + 1));
    } else if (source.IsMap()) {
      convert_map(source, depth, node);
    }
    return node;
  }

 private:
  void convert_map(const YAML::Node& source, int depth, YamlNode& node) {
    node.kind = YamlNode::Kind::kMap;
    std::set<std::string> keys;
    for (const auto& entry : source) {
      const std::string where = fmt::format("{}:{}", name_, entry.first.Mark().line + 1);
      if (!entry.first.IsScalar()) throw std::runtime_error(where + ": a key must be a plain word");
      const std::string key = entry.first.Scalar();
      if (!keys.insert(key).second) {
        throw std::runtime_error(fmt::format("{}: key '{}' appears twice; keep one", where, key));
      }
      node.entries.push_back({key, convert(entry.second, depth + 1)});
      node.entries.back().value.where = where;
    }
  }

  std::string name_;
  std::size_t most_;
  std::size_t count_ = 0;
};

/// Throws std::runtime_error if the text is not UTF-8. A byte order mark of UTF-16 or UTF-32 is
/// left to the parser.
void require_utf8(const std::string& text, const std::string& name) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
      text.starts_with(std::string_view("\0\0\xfe\xff", 4))) {
    return;
  }
  const auto at = find_invalid_utf8(text);
  if (!at) return;
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*at), '\n');
  throw std::runtime_error(
      fmt::format("{}:{}: byte 0x{:02x} is no text in UTF-8; save the file as UTF-8", name, line,
                  static_cast<unsigned char>(text[*at])));
}

}  // namespace

YamlNode* YamlNode::find(const std::string& key) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

const YamlNode* YamlNode::find(const std::string& key) const {
  return const_cast<YamlNode*>(this)->find(key);
}

YamlNode yaml_scalar(std::string text) {
  YamlNode node;
  node.kind = YamlNode::Kind::kScalar;
  node.scalar = std::move(text);
  return node;
}

YamlNode parse_yaml(const std::string& text, const std::string& name) {
  require_utf8(text, name);
  try {
    return Converter(name, text.size()).convert(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(
        fmt::format("{}:{}: not valid YAML: {}", name, error.mark.line + 1, error.msg));
  }
}

}  // namespace castaway::testbed
