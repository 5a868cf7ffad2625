/// HTML helpers: escaped text, readable numbers, embedded bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Escapes `text` for HTML content and attributes.
std::string escape_html(std::string_view text);

/// Base64 (RFC 4648) with padding; needs no escaping in HTML.
std::string base64(std::string_view bytes);

/// `data:` URI of a PNG's bytes.
std::string png_data_uri(std::string_view png);

/// Formats three significant digits without an exponent, and the unit: "0.0342 m", "12.3 s", "1230
/// m". A missing value gives a dash.
std::string readable(const std::optional<double>& value, std::string_view unit = "");

}  // namespace castaway::testbed
