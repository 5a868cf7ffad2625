#include "tools/pages/runs/expectation_list.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"

namespace castaway::testbed {

std::string expectation_list(const std::vector<Check>& checks) {
  if (checks.empty()) return "";
  const auto met =
      std::count_if(checks.begin(), checks.end(), [](const Check& check) { return check.met; });
  std::string html = fmt::format("<p>Expectations: {} of {} met.</p>\n<ul>\n", met, checks.size());
  for (const Check& check : checks) {
    const std::string value = check.value ? fmt::format("{:.4g}", *check.value) : "not measured";
    html += fmt::format("<li class=\"{}\">{}: {} {} ({}; {})</li>\n", check.met ? "met" : "unmet",
                        check.met ? "met" : "not met", escape_html(check.expectation.metric),
                        escape_html(to_string(check.expectation.condition)), value,
                        check.seed ? fmt::format("seed {}", *check.seed)
                                   : escape_html(to_string(check.expectation.over)));
  }
  return html + "</ul>\n";
}

}  // namespace castaway::testbed
