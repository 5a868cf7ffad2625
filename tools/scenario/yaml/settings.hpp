/// Tables of settings: each setting is listed once, with its unit, its range and one sentence. The
/// table is used to read, check and document it, and to write it into the effective scenario.
///
/// A table is a function `void fields(Settings settings, Config& config)`. A function that visits
/// every field follows Drake's `Serialize(Archive*)`.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Entry of one setting in a table.
struct Setting {
  const char* key;
  const char* unit;     ///< Such as "m" or "rad/s"; empty for none.
  const char* what;     ///< One sentence.
  NumberRange range{};  ///< Range of a number, and of every number of a list.
};

/// A setting as shown in the documentation.
struct SettingText {
  std::string path;   ///< Such as "drive.max_speed".
  std::string value;  ///< Default.
  std::string range;  ///< Such as "0.001 to 100" or "zstd, lz4, none"; empty: any value.
  std::string unit;
  std::string what;
};

/// Visitor of a table: reads its settings from a map of a YAML document, or describes them.
class Settings {
 public:
  /// Reads all settings; missing ones keep their values and are written into the document.
  static Settings reading(const YamlReader& map) { return {map, true}; }
  /// Reads the settings that are present and writes nothing, for changes to a robot's description.
  static Settings changing(const YamlReader& map) { return {map, false}; }
  /// Appends descriptions to `texts`, which must outlive the visitor. `prefix`: "drive." or empty.
  static Settings describing(std::vector<SettingText>& texts, const std::string& prefix) {
    return {texts, prefix};
  }

  /// True while the table is being described; every field must then be listed.
  [[nodiscard]] bool describes() const { return texts_ != nullptr; }

  /// A setting of any type that `read_yaml` supports. Returns true if it was present. Throws
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

  /// An optional setting; a missing one is not written into the document.
  template <typename T>
  bool optional(const Setting& about, std::optional<T>& value) {
    if (texts_ != nullptr) return describe(about, {});
    if (!map_ || !check(about)) return false;
    value = *map_->get_optional<T>(about.key);
    return true;
  }

  /// A setting with one of several names as its value.
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

  /// A setting with a special syntax, which its own reader handles; it is only described here.
  void form(const Setting& about, const std::string& value);

  /// Visitor of the map under `key`.
  [[nodiscard]] Settings group(const std::string& key);
  /// True if the map has `key`, or while describing.
  [[nodiscard]] bool has(const std::string& key);
  /// Throws an error at the place of this map.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  Settings(const YamlReader& map, bool fills) : map_(map), fills_(fills) {}
  Settings(std::vector<SettingText>& texts, std::string prefix)
      : texts_(&texts), prefix_(std::move(prefix)) {}
  Settings() = default;

  /// True if the setting is present and in range.
  bool check(const Setting& about);
  bool describe(const Setting& about, const YamlNode& value);
  bool choose(const Setting& about, std::size_t& index, const std::vector<std::string>& allowed);

  std::optional<YamlReader> map_;  ///< Nothing for a missing group, or while describing.
  bool fills_ = false;
  std::vector<SettingText>* texts_ = nullptr;
  std::string prefix_;
};

}  // namespace castaway::testbed
