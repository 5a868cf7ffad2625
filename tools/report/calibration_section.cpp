#include "tools/report/calibration_section.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/formats/json_number.hpp"
#include "tools/report/html/html.hpp"
#include "tools/report/html/reliability_plot.hpp"
#include "tools/report/report_words.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// The bins of a localizer; an empty list where there are none.
Json bins_of(const Json& figures) {
  const Json::json_pointer path("/calibration/bins");
  return figures.contains(path) ? figures.at(path) : Json::array();
}

ReliabilityCurve curve_of(const std::string& name, const Json& figures, std::size_t color) {
  ReliabilityCurve curve{name, color, {}};
  for (const Json& bin : bins_of(figures)) {
    if (bin.at("scans") == 0) continue;
    curve.points.push_back({bin.at("stated"), bin.at("observed"), bin.at("interval").at(0),
                            bin.at("interval").at(1), bin.at("scans")});
  }
  return curve;
}

std::string table_row(const Json& localizers, std::size_t index) {
  std::string label;
  std::string cells;
  for (const auto& [name, figures] : localizers.items()) {
    const Json bin = bins_of(figures).at(index);
    label = fmt::format("{:g} to {:g}", bin.at("from").get<double>(), bin.at("to").get<double>());
    const auto scans = whole<std::int64_t>(bin.at("scans"));
    cells += scans == 0
                 ? "<td>–</td>"
                 : fmt::format("<td>{} of {}</td>", whole<std::int64_t>(bin.at("right")), scans);
  }
  return fmt::format("<tr><td>{}</td>{}</tr>", label, cells);
}

/// Brier scores and, a line a tenth, how many outputs were right.
std::string counts_table(const Json& localizers) {
  std::string head = "<th>stated</th>";
  std::string brier = "<tr><td>Brier score</td>";
  std::size_t bins = 0;
  for (const auto& [name, figures] : localizers.items()) {
    head += "<th>" + escape_html(name) + "</th>";
    brier += "<td>" + readable(figure_at(figures, "/calibration/brier")) + "</td>";
    bins = bins_of(figures).size();
  }
  std::string body = brier + "</tr>";
  for (std::size_t i = 0; i < bins; ++i) body += table_row(localizers, i);
  return fmt::format(
      "<div class=\"wide\"><table><thead><tr>{}</tr></thead><tbody>{}</tbody></table></div>\n",
      head, body);
}

}  // namespace

std::string calibration_html(const RunFolder& run) {
  const Json& localizers = run.summary["localizers"];
  std::vector<ReliabilityCurve> curves;
  for (const auto& [name, figures] : localizers.items()) {
    if (bins_of(figures).empty()) return "";
    curves.push_back(curve_of(name, figures, curves.size()));
  }
  if (curves.empty()) return "";
  return render_reliability(curves) +
         "<p class=\"soft\">Left: of the outputs with nearly the same stated probability, the "
         "share "
         "that is right, with its 95 % interval; on the dotted line a statement is what comes of "
         "it, below it the localizer is too sure. Right: how often it was stated. Brier score: "
         "mean "
         "square of the difference, 0 is perfect.</p>\n" +
         counts_table(localizers);
}

}  // namespace castaway::testbed
