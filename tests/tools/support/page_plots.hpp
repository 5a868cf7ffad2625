/// Parses the plots of a page, for tests.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// Every plot of the page; "times" is the x shared by its group.
inline nlohmann::ordered_json plots_in(const std::string& html) {
  const std::string start = "</div><script type=\"application/json\">";
  auto plots = nlohmann::ordered_json::array();
  for (std::size_t at = html.find(start); at != std::string::npos; at = html.find(start, at + 1)) {
    const std::size_t begin = at + start.size();
    const auto group =
        nlohmann::ordered_json::parse(html.substr(begin, html.find("</script>", begin) - begin));
    for (auto plot : group.at("plots")) {
      if (group.contains("x")) plot["times"] = group["x"];
      plots.push_back(std::move(plot));
    }
  }
  return plots;
}

/// The page without its script elements.
inline std::string without_scripts(const std::string& html) {
  std::string text;
  std::size_t end = 0;
  for (std::size_t at = html.find("<script"); at != std::string::npos;
       at = html.find("<script", end)) {
    text += html.substr(end, at - end);
    end = html.find("</script>", at);
  }
  return text + html.substr(end);
}

}  // namespace castaway::testbed
