#include "tools/pages/campaign/specification_section.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/campaign/figures/units.hpp"
#include "tools/pages/campaign/figures/value_labels.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {
namespace {

/// Values of a key: elements of a list, told apart where they are lists themselves.
std::string values_words(const YamlNode& value) {
  std::string words;
  const bool nested = std::any_of(value.items.begin(), value.items.end(), [](const YamlNode& item) {
    return item.kind != YamlNode::Kind::kScalar;
  });
  if (!nested) return value_words(value);
  for (const YamlNode& item : value.items) {
    words += (words.empty() ? "" : "; ") + value_words(item);
  }
  return words;
}

std::string specification_row(const std::string& what, const std::string& key,
                              const YamlNode& value) {
  const std::string unit = key.empty() ? "" : key_unit(key);
  return fmt::format(
      "<tr><td data-head=\"\">{}</td><td data-head=\"key\"><span>{}{}</span></td>"
      "<td data-head=\"values\">{}</td></tr>\n",
      escape_html(what), escape_html(key),
      unit.empty() ? "" : escape_html(fmt::format(" [{}]", unit)),
      escape_html(values_words(value)));
}

/// A row for each key of a map of keys, and one for any other entry.
std::string specification_rows(const YamlNode& specification) {
  std::string rows;
  for (const YamlEntry& entry : specification.entries) {
    if (entry.key == "scenario" || value_words(entry.value).empty()) continue;
    if (entry.key != "grid" && entry.key != "draw") {
      rows += specification_row(entry.key, "", entry.value);
      continue;
    }
    for (const YamlEntry& varied : entry.value.entries) {
      rows += specification_row(entry.key, varied.key, varied.value);
    }
  }
  return rows;
}

}  // namespace

std::string specification_section(const CampaignSpec& spec) {
  const YamlNode specification = parse_yaml(spec.effective, spec.file);
  return html_section(
      "Specification",
      fmt::format("<div class=\"wide\"><table class=\"stack specification\"><thead><tr><th></th>"
                  "<th>key</th><th>values</th></tr></thead><tbody>\n{}</tbody></table></div>\n"
                  "<details><summary>All of it, with the scenario: campaign.yaml</summary>\n"
                  "<pre>{}</pre></details>\n",
                  specification_rows(specification), escape_html(spec.effective)));
}

}  // namespace castaway::testbed
