/// The common frame of all pages: self-contained, in the report's style.
#pragma once

#include <optional>
#include <string>

#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {

/// Content of a page.
struct HtmlPage {
  std::string title{};  ///< Plain text.
  std::string body{};   ///< HTML, including data for scripts.
  std::string body_class{};
  std::string style{};                ///< In addition to the report's style.
  std::optional<WebBundle> bundle{};  ///< Embedded at the end of the body.
  bool talks = false;                 ///< Its script may talk to the server of the page.
};

/// Renders the page. Its content security policy forbids loading anything, whatever its texts
/// contain, and talking to anybody but its server if it `talks`.
std::string html_page(const HtmlPage& page);

/// Renders a section with a heading. `title` is plain text.
std::string html_section(const std::string& title, const std::string& body);

}  // namespace castaway::testbed
