/// Tables of settings: each setting is listed once, with its unit, its range and one sentence. From
/// there it is read, checked, written into the effective scenario and documented.
///
/// A table is a function `void fields(Settings settings, Config& config)`. The idea of a function
/// that visits every field is that of Drake's `Serialize(Archive*)`.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// What a table says of one setting.
struct Setting {
  const char* key;
  const char* unit;     ///< "m", "rad/s"; empty: none.
  const char* what;     ///< One sentence.
  NumberRange range{};  ///< Of a number, and of every number of a list.
};

/// A setting as the docs show it.
struct SettingText {
  std::string path;   ///< "drive.max_speed"
  std::string value;  ///< Default.
  std::string range;  ///< "0.001 to 100", "zstd, lz4, none"; empty: any.
  std::string unit;
  std::string what;
};

/// Goes through a table: reads its settings from a map of a YAML document, or describes them.
class Settings {
 public:
  /// What is not given keeps its value and is written into the document.
  static Settings reading(const YamlReader& map) { return {map, true}; }
  /// Takes what is given and writes nothing: for values that differ from a robot's description.
  static Settings changing(const YamlReader& map) { return {map, false}; }
  /// Appends to `texts`, which must outlive it. `prefix`: "drive." or nothing.
  static Settings describing(std::vector<SettingText>& texts, const std::string& prefix) {
    return {texts, prefix};
  }

  /// True if the table is being described: then every field is to be listed.
  [[nodiscard]] bool describes() const { return texts_ != nullptr; }

  /// A setting of any type that `read_yaml` knows. Returns true where it was given. Throws
  /// std::runtime_error naming place, key and range.
  template <typename T>
  bool field(const Setting& about, T& value) {
    if (texts_ != nullptr) return describe(about, write_yaml(value));
    if (!map_) return false;
    if (!check(about)) {
      if (fills_) (void)map_->get(about.key, value);
      return false;
    }
    value = *map_->get_optional<T>(about.key);
    return true;
  }

  /// A setting that may be absent: nothing is written then.
  template <typename T>
  bool optional(const Setting& about, std::optional<T>& value) {
    if (texts_ != nullptr) return describe(about, {});
    if (!map_ || !check(about)) return false;
    value = *map_->get_optional<T>(about.key);
    return true;
  }

  /// One of several names.
  template <typename E>
  bool choice(const Setting& about, E& value, const std::vector<std::pair<std::string, E>>& names) {
    std::size_t index = 0;
    std::vector<std::string> allowed;
    for (const auto& [name, meaning] : names) {
      if (meaning == value) index = allowed.size();
      allowed.push_back(name);
    }
    const bool given = choose(about, index, allowed);
    value = names[index].second;
    return given;
  }
  bool choice(const Setting& about, std::string& value, const std::vector<std::string>& names);

  /// A setting with forms of its own, which its reader takes care of: here it is described only.
  void form(const Setting& about, const std::string& value);

  /// The map under `key`.
  [[nodiscard]] Settings group(const std::string& key);
  /// True if the map has `key`, or is being described.
  [[nodiscard]] bool has(const std::string& key);
  /// What cannot be, at the place of this map.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  Settings(const YamlReader& map, bool fills) : map_(map), fills_(fills) {}
  Settings(std::vector<SettingText>& texts, std::string prefix)
      : texts_(&texts), prefix_(std::move(prefix)) {}
  Settings() = default;

  /// True where the setting is given and in its range.
  bool check(const Setting& about);
  bool describe(const Setting& about, const YamlNode& value);
  bool choose(const Setting& about, std::size_t& index, const std::vector<std::string>& allowed);

  std::optional<YamlReader> map_;  ///< Nothing: a group that is not there, or describing.
  bool fills_ = false;
  std::vector<SettingText>* texts_ = nullptr;
  std::string prefix_;
};

}  // namespace castaway::testbed
