#include "tools/scenario/localizers/yaml_json.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// The whole text as a T; nothing if it is none.
template <typename T>
std::optional<T> number(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end && !text.empty() ? std::optional(value) : std::nullopt;
}

Json scalar(const std::string& text) {
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  if (const auto integer = number<std::int64_t>(text)) return *integer;
  const auto real = number<double>(text);
  return real && std::isfinite(*real) ? Json(*real) : Json(text);
}

}  // namespace

Json yaml_json(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      return nullptr;
    case YamlNode::Kind::kScalar:
      return scalar(node.scalar);
    case YamlNode::Kind::kList: {
      Json list = Json::array();
      for (const YamlNode& item : node.items) list.push_back(yaml_json(item));
      return list;
    }
    case YamlNode::Kind::kMap:
      break;
  }
  Json map = Json::object();
  for (const YamlEntry& entry : node.entries) map[entry.key] = yaml_json(entry.value);
  return map;
}

}  // namespace castaway::testbed
