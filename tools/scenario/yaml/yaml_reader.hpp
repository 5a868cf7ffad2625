/// Strict, typed reading of YAML with defaults; errors state the place and the problem.
///
///     YamlDocument document = YamlDocument::load("scenario.yaml");
///     document.set("lidar.rate_hz=5");                        // --set
///     YamlReader root = document.root();
///     config.seed = root.get("seed", config.seed);            // typed, default
///     config.rate_hz = root.child("lidar").get("rate_hz", 10.0);
///     for (YamlReader event : root.list("events")) {          // - kidnap: {at_s: 30}
///       auto [kind, body] = event.name_and_body();
///       kidnap.at_s = body.require<double>("at_s");
///     }
///     document.reject_unknown_keys();                         // after all has been read
///     save(document.effective());                             // with every default filled in
///
/// Every error begins with "file:line: " (or "--set a.b=c: ").
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "tools/scenario/yaml/number_range.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

/// Supported types: bool, int, std::uint64_t, double (at most 1e9 in magnitude), std::string,
/// std::vector<double>, std::vector<std::string>, Eigen::Vector2d, Eigen::Vector3d.
template <typename T>
T read_yaml(const YamlNode& node, const std::string& path);

/// The inverse of `read_yaml`; doubles are written in the shortest form that reads back exactly.
YamlNode write_yaml(bool value);
YamlNode write_yaml(int value);
YamlNode write_yaml(std::uint64_t value);
YamlNode write_yaml(double value);
YamlNode write_yaml(const std::string& value);
YamlNode write_yaml(const std::vector<double>& value);
YamlNode write_yaml(const std::vector<std::string>& value);
YamlNode write_yaml(const Eigen::Vector2d& value);
YamlNode write_yaml(const Eigen::Vector3d& value);

/// A view of one value of a document, which must outlive it. Reading fills defaults into the
/// document and records which keys are known.
class YamlReader {
 public:
  YamlReader(YamlNode& node, std::string path) : node_(&node), path_(std::move(path)) {}

  [[nodiscard]] bool is_null() const { return node_->kind == YamlNode::Kind::kNull; }
  [[nodiscard]] bool is_scalar() const { return node_->kind == YamlNode::Kind::kScalar; }
  [[nodiscard]] bool is_list() const { return node_->kind == YamlNode::Kind::kList; }
  [[nodiscard]] bool is_map() const { return node_->kind == YamlNode::Kind::kMap; }
  /// True if the value was given on the command line, not in a file.
  [[nodiscard]] bool is_from_command_line() const { return node_->is_override; }
  /// Keys from the root, such as "events[0].kidnap".
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Converts this value to a T.
  template <typename T>
  [[nodiscard]] T as() const {
    return read_yaml<T>(*node_, path_);
  }

  /// True if the map has `key` with a value. Marks `key` as known.
  [[nodiscard]] bool has(const std::string& key) { return find(key).has_value(); }
  /// The value of `key`; nothing if it is missing or `~`.
  [[nodiscard]] std::optional<YamlReader> find(const std::string& key);
  /// The map under `key`; created empty if missing.
  [[nodiscard]] YamlReader child(const std::string& key);
  /// The elements of the list under `key`; empty if missing.
  [[nodiscard]] std::vector<YamlReader> list(const std::string& key);
  /// This value as written; marks all keys in it as known.
  [[nodiscard]] YamlNode raw() const;
  /// This value as written; marks no keys as known.
  [[nodiscard]] YamlNode copy() const;
  /// The elements of this list.
  [[nodiscard]] std::vector<YamlReader> items() const;
  /// Keys and values of a map whose keys are chosen by the user; marks all keys as known.
  [[nodiscard]] std::vector<std::pair<std::string, YamlReader>> entries();
  /// A name with an optional body: `amcl`, or a map of one key `amcl: {...}`.
  [[nodiscard]] std::pair<std::string, YamlReader> name_and_body();

  /// The value of `key`, or `fallback`, which is then written into the effective document.
  template <typename T>
  [[nodiscard]] T get(const std::string& key, const T& fallback) {
    if (const auto found = find(key)) return found->template as<T>();
    fill(key, write_yaml(fallback));
    return fallback;
  }
  [[nodiscard]] std::string get(const std::string& key, const char* fallback) {
    return get(key, std::string(fallback));
  }
  /// The value of `key`; a missing one is an error.
  template <typename T>
  [[nodiscard]] T require(const std::string& key) {
    return required(key).template as<T>();
  }
  /// The value of `key` if present; no default is filled in.
  template <typename T>
  [[nodiscard]] std::optional<T> get_optional(const std::string& key) {
    const auto found = find(key);
    return found ? std::optional<T>(found->template as<T>()) : std::nullopt;
  }
  /// The value of `key`, which must be one of `allowed`.
  [[nodiscard]] std::string choice(const std::string& key, const std::string& fallback,
                                   const std::vector<std::string>& allowed);

  /// Throws std::runtime_error naming place, key and range if this number, or one of this list, is
  /// out of range.
  void require_in(const NumberRange& range, const std::string& unit) const {
    testbed::require_in(*node_, path_, range, unit);
  }

  /// Throws std::runtime_error "file:line: path: message".
  [[noreturn]] void fail(const std::string& message) const;

 private:
  [[nodiscard]] std::string path_of(const std::string& key) const;
  YamlReader required(const std::string& key);
  void fill(const std::string& key, YamlNode value);
  void expect_map();

  YamlNode* node_;
  std::string path_;
};

/// A YAML file being read. Readers point into it; moving it keeps them valid.
class YamlDocument {
 public:
  /// Throws std::runtime_error if the file cannot be read or is malformed.
  static YamlDocument load(const std::filesystem::path& file);
  /// `name` stands for the file in errors.
  static YamlDocument parse(const std::string& text, const std::string& name);

  /// A tree that was parsed elsewhere.
  explicit YamlDocument(YamlNode root) : root_(std::make_unique<YamlNode>(std::move(root))) {}

  /// Applies `key=value` (see `apply_override`); call it before reading.
  void set(const std::string& assignment) { apply_override(*root_, assignment); }
  /// Sets `key` to a text as it is; call it before reading.
  void set_text(const std::string& key, std::string text) {
    put_value(*root_, key, yaml_scalar(std::move(text)), "--set " + key);
  }
  /// Expands a key's short form (see `castaway::testbed::expand_short_form`); call it before
  /// reading.
  void expand_short_form(const std::string& key, const std::string& long_key) {
    testbed::expand_short_form(*root_, key, long_key);
  }
  [[nodiscard]] YamlReader root() { return {*root_, ""}; }
  /// Throws on the first key that no reader has requested, naming the nearest requested one.
  void reject_unknown_keys() const;
  /// YAML text of all values, including defaults; reading it gives the same configuration.
  [[nodiscard]] std::string effective() const { return emit_yaml(*root_); }

 private:
  std::unique_ptr<YamlNode> root_;
};

}  // namespace castaway::testbed
