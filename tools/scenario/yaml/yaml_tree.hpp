/// YAML as a plain tree that records where every value was written.
#pragma once

#include <list>
#include <string>
#include <vector>

namespace castaway::testbed {

struct YamlEntry;

/// A value. Its lists keep references to elements valid when they grow.
struct YamlNode {
  enum class Kind { kNull, kScalar, kList, kMap };

  Kind kind = Kind::kNull;
  std::string scalar;              ///< Text of a scalar, without quotes.
  std::list<YamlNode> items;       ///< Elements of a list.
  std::list<YamlEntry> entries;    ///< Keys and values of a map, in order of the file.
  std::string where;               ///< "file:line" or "--set a.b=c"; empty for a default.
  bool is_override = false;        ///< Given on the command line, not in a file.
  std::vector<std::string> known;  ///< Keys that a reader requested from this map.

  /// The value of `key`, or nullptr.
  [[nodiscard]] YamlNode* find(const std::string& key);
  [[nodiscard]] const YamlNode* find(const std::string& key) const;
};

/// A key and its value.
struct YamlEntry {
  std::string key;
  YamlNode value;
};

/// A scalar without a place.
YamlNode yaml_scalar(std::string text);

/// Parses one YAML document. `name` is the file's name in errors and in `where`. Throws
/// std::runtime_error on malformed text and duplicate keys, naming file and line.
YamlNode parse_yaml(const std::string& text, const std::string& name);

/// Applies `path=value` (`events.0.kidnap.at_s=30`) to the tree. Missing keys are created, so that
/// readers check them like those of the file; a list accepts indices up to its length. The value is
/// YAML. Throws std::invalid_argument if the path does not match the tree.
void apply_override(YamlNode& root, const std::string& assignment);

/// Sets `value` at `path` as `apply_override` does; `where` is its place in errors.
void put_value(YamlNode& root, const std::string& path, YamlNode value, const std::string& where);

/// Expands the short form of a key: a scalar `key: value` becomes `key: {long_key: value}`, so that
/// other keys can be added. Does nothing if the value is not a scalar.
void expand_short_form(YamlNode& root, const std::string& key, const std::string& long_key);

/// Formats the tree as block-style YAML; parsing the text gives the same tree.
std::string emit_yaml(const YamlNode& root);

}  // namespace castaway::testbed
