#include "tools/scenario/yaml/number_range.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>

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

bool holds(const NumberRange& range, double value) {
  return (value >= range.low && value <= range.high) || (range.zero_too && value == 0.0);
}

}  // namespace

std::string range_text(const NumberRange& range) {
  if (range.low == NumberRange{}.low && range.high == NumberRange{}.high) return "";
  return fmt::format("{}{} to {}", range.zero_too ? "0, or " : "", range.low, range.high);
}

void require_in(const YamlNode& node, const std::string& name, const NumberRange& range,
                const std::string& unit) {
  for (const YamlNode& item : node.items) {
    if (item.kind == Kind::kScalar) require_in(item, name, range, unit);
  }
  if (node.kind != Kind::kScalar) return;
  const std::optional<double> value = number_in(node.scalar);
  if (!value || holds(range, *value)) return;
  throw std::runtime_error(fmt::format(
      "{}: {}: {} is out of range; give {}from {} to {}{}{}", node.where, name, node.scalar,
      range.zero_too ? "0, or " : "", range.low, range.high, unit.empty() ? "" : " ", unit));
}

}  // namespace castaway::testbed
