/// The frame of every page: self-contained, in the report's style.
#pragma once

#include <optional>
#include <string>

#include "tools/report/html/web_bundle.hpp"

namespace castaway::testbed {

/// What a page is made of.
struct HtmlPage {
  std::string title{};  ///< Plain text.
  std::string body{};   ///< HTML, scripts' data included.
  std::string body_class{};
  std::string style{};                ///< Besides the report's.
  std::optional<WebBundle> bundle{};  ///< Runs at the end of the body.
};

/// The page; its policy lets nothing be loaded from anywhere, whatever its texts hold.
std::string html_page(const HtmlPage& page);

/// A titled part of a page. `title`: plain text.
std::string html_section(const std::string& title, const std::string& body);

}  // namespace castaway::testbed
