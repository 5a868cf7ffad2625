/// Converts messages of a bag to JSON, for the types in castaway's own bags.
///
/// The message structs are of `ros_*.hpp`, which the build generates from msg/*.msg.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

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

/// Fields of a CDR message; nothing for an unknown type. Throws std::runtime_error if the message
/// is malformed.
std::optional<nlohmann::ordered_json> message_json(const std::string& type, std::string_view data);

}  // namespace castaway::testbed
