#include "tools/base/formats/html.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return valid_utf8(std::move(escaped));
}

std::string png_data_uri(std::string_view png) { return "data:image/png;base64," + base64(png); }

std::string readable(const std::optional<double>& value, std::string_view unit) {
  if (!value || !std::isfinite(*value)) return "–";
  const double magnitude = std::abs(*value);
  int digits = 0;
  if (magnitude > 0.0 && magnitude < 100.0) {
    digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(magnitude))), 0, 4);
  }
  constexpr double kLeast = 0.00005;  // Smaller numbers would read 0.
  const std::string number = magnitude > 0.0 && magnitude < kLeast
                                 ? fmt::format("{:.0e}", *value)
                                 : fmt::format("{:.{}f}", *value, digits);
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

}  // namespace castaway::testbed
