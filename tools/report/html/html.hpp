/// Pieces of HTML: escaped text, numbers for readers, embedded bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Text that HTML takes as text, also in attributes.
std::string escape_html(std::string_view text);

/// Bytes as text of 64 signs, none of which means anything to HTML.
std::string base64(std::string_view bytes);

/// `data:` address of a PNG's bytes.
std::string png_data_uri(std::string_view png);

/// Three significant digits without an exponent, and the unit: "0.0342 m", "12.3 s", "1230 m"; a
/// dash where there is nothing.
std::string readable(const std::optional<double>& value, std::string_view unit = "");

}  // namespace castaway::testbed
