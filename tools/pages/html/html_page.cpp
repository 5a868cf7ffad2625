#include "tools/pages/html/html_page.hpp"

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/report_style.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kPolicy =
    "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src "
    "'unsafe-inline'";

}  // namespace

std::string html_page(const HtmlPage& page) {
  const std::string script =
      page.bundle ? fmt::format("<script>{}</script>\n", page.bundle->script) : "";
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>castaway: {}</title><style>{}{}{}</style></head>\n<body class=\"{}\">\n"
      "<main>\n{}</main>\n{}</body></html>\n",
      std::string(kPolicy) + (page.talks ? "; connect-src 'self'" : ""), escape_html(page.title),
      kReportStyle, page.style, page.bundle ? page.bundle->style : "", page.body_class, page.body,
      script);
}

std::string html_section(const std::string& title, const std::string& body) {
  return fmt::format("<section><h2>{}</h2>\n{}</section>\n", escape_html(title), body);
}

}  // namespace castaway::testbed
