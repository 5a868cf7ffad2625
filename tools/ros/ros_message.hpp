/// What can be done with any message struct of `ros_*.hpp`: its definition as text, itself as JSON.
///
/// Each struct lists its fields once, in `visit`; CDR, definition and JSON all go by that list.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// "std_msgs/Header" of "std_msgs/msg/Header": how definitions name types.
std::string short_type_name(const std::string& type);

/// Puts a definition together in the form `ros2msg`: the fields of the message, then those of all
/// messages in it, each behind a line of 80 '=' and "MSG: package/Name". Constants and comments are
/// left out; no reader needs them to decode a message.
class RosDefinition {
 public:
  template <typename Message>
  static std::string of() {
    RosDefinition definition;
    Message message;
    Message::visit(message, definition);
    return definition.text();
  }

  template <typename T>
  void operator()(const char* name, const T& value) {
    fields_ += name_of(value) + " " + name + "\n";
  }

 private:
  static std::string name_of(bool) { return "bool"; }
  static std::string name_of(std::int8_t) { return "int8"; }
  static std::string name_of(std::uint8_t) { return "uint8"; }
  static std::string name_of(std::int32_t) { return "int32"; }
  static std::string name_of(std::uint32_t) { return "uint32"; }
  static std::string name_of(float) { return "float32"; }
  static std::string name_of(double) { return "float64"; }
  static std::string name_of(const std::string&) { return "string"; }
  template <typename T>
  std::string name_of(const std::vector<T>&) {
    return name_of(T{}) + "[]";
  }
  template <typename T, std::size_t N>
  std::string name_of(const std::array<T, N>&) {
    return name_of(T{}) + "[" + std::to_string(N) + "]";
  }
  template <typename T>
  requires std::is_class_v<T> std::string name_of(const T& message) {
    RosDefinition part;
    T::visit(message, part);
    need(T::kType, part);
    return short_type_name(T::kType);
  }

  /// Adds a message that the definition needs, and those that it needs, once each.
  void need(const char* type, const RosDefinition& definition);
  [[nodiscard]] std::string text() const;

  std::string fields_;
  std::vector<std::pair<std::string, std::string>> needed_;  // Type, fields.
};

/// A message as JSON, field by field; NaN and infinities as "nan", "inf" and "-inf".
class RosJson {
 public:
  template <typename Message>
  static nlohmann::ordered_json of(const Message& message) {
    RosJson json;
    Message::visit(message, json);
    return std::move(json.json_);
  }

  template <typename T>
  void operator()(const char* name, const T& value) {
    json_[name] = value_of(value);
  }

 private:
  template <typename T>
  static nlohmann::ordered_json value_of(const T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      if (std::isnan(value)) return "nan";
      if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
      return static_cast<double>(value);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      return value;
    } else {
      return of(value);
    }
  }
  template <typename T>
  static nlohmann::ordered_json value_of(const std::vector<T>& values) {
    auto json = nlohmann::ordered_json::array();
    for (const T& value : values) json.push_back(value_of(value));
    return json;
  }
  template <typename T, std::size_t N>
  static nlohmann::ordered_json value_of(const std::array<T, N>& values) {
    auto json = nlohmann::ordered_json::array();
    for (const T& value : values) json.push_back(value_of(value));
    return json;
  }

  nlohmann::ordered_json json_ = nlohmann::ordered_json::object();
};

}  // namespace castaway::testbed
