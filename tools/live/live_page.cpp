#include "tools/live/live_page.hpp"

#include <stdexcept>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {

std::string live_page(const std::string& scenario) {
  const auto bundle = live_bundle();
  if (!bundle) {
    throw std::runtime_error(
        "this castaway was built without Node.js, so it has no page for live runs; install node "
        "and "
        "npm, and build it again");
  }
  return html_page({.title = scenario + ", live",
                    .body = "<div id=\"castaway-theme-place\"></div>\n<h1>" +
                            escape_html(scenario) + "</h1>\n<div id=\"castaway-live\"></div>\n",
                    .bundle = bundle,
                    .talks = true});
}

}  // namespace castaway::testbed
