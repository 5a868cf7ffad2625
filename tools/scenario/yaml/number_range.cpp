#include "tools/scenario/yaml/number_range.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

using Kind = YamlNode::Kind;

std::optional<double> number_in(const std::string& text) {
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + sign, end, value);
  if (stop != end || text.size() == sign) return std::nullopt;
  if (error == std::errc{}) return value;
  return error == std::errc::result_out_of_range ? std::optional(value) : std::nullopt;
}

std::string bounds(const NumberRange& range) {
  return fmt::format("{}from {} to {}{}{}", range.zero_too ? "0, or " : "", range.low, range.high,
                     *range.unit == '\0' ? "" : " ", range.unit);
}

/// A value against what is left of a range's path.
class Check {
 public:
  explicit Check(const NumberRange& range) : range_(range) {}

  void visit(const YamlNode& node, std::string_view path, const std::string& name) const {
    if (path.empty()) return judge(node, name);
    const std::size_t dot = path.find('.');
    const std::string_view key = path.substr(0, dot);
    const std::string_view rest = dot == path.npos ? "" : path.substr(dot + 1);
    for (const YamlEntry& entry : node.entries) {
      if (key == "*" || key == entry.key) visit(entry.value, rest, joined(name, entry.key));
    }
    std::size_t index = 0;
    for (const YamlNode& item : node.items) {
      const std::string at = fmt::format("{}[{}]", name, index++);
      if (key == "*") visit(item, rest, at);
    }
  }

 private:
  static std::string joined(const std::string& name, const std::string& key) {
    return name.empty() ? key : name + "." + key;
  }

  void judge(const YamlNode& node, const std::string& name) const {
    for (const YamlNode& item : node.items) {
      if (item.kind == Kind::kScalar) judge(item, name);
    }
    if (node.kind != Kind::kScalar) return;
    const std::optional<double> value = number_in(node.scalar);
    if (!value || (*value >= range_.low && *value <= range_.high)) return;
    if (range_.zero_too && *value == 0.0) return;
    throw std::runtime_error(fmt::format("{}: {}: {} is out of range; give {}", node.where, name,
                                         node.scalar, bounds(range_)));
  }

  const NumberRange& range_;
};

}  // namespace

void require_ranges(const YamlNode& root, std::span<const NumberRange> ranges) {
  for (const NumberRange& range : ranges) Check(range).visit(root, range.path, "");
}

}  // namespace castaway::testbed
