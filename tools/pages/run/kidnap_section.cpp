#include "tools/pages/run/kidnap_section.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/outputs/pictures/localizer_styles.hpp"
#include "tools/outputs/records/summary_kidnaps.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/line_chart.hpp"
#include "tools/run/event_names.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

using MaybePose = std::optional<localization::SE2>;

/// A kidnap, or a start at an unknown pose.
struct KidnapRow {
  double at_s = 0.0;
  std::string kind;
  MaybePose T_map_from{};
  MaybePose T_map_to{};
  std::vector<std::optional<SummaryKidnap>> outcomes{};  ///< By localizer.

  [[nodiscard]] bool has_failure() const {
    return std::any_of(outcomes.begin(), outcomes.end(), [](const auto& outcome) {
      return outcome && outcome->scored && !outcome->recovered;
    });
  }
};

std::vector<KidnapRow> kidnap_events(const RunFolder& run, std::size_t localizers) {
  std::vector<KidnapRow> rows;
  for (const ReportEvent& event : run.events) {
    const auto* kidnap = std::get_if<KidnapEvent>(&event.what);
    if (kidnap == nullptr) continue;
    rows.push_back({event.stamp_s, part_name(kidnap->how), event.T_map_from, event.T_map_to,
                    std::vector<std::optional<SummaryKidnap>>(localizers)});
  }
  return rows;
}

/// The row of a kidnap; a new one for a start.
KidnapRow& row_for(const SummaryKidnap& kidnap, std::size_t localizers,
                   std::vector<KidnapRow>& rows) {
  constexpr double kSameTime = 1e-3;  // [s]
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const KidnapRow& row) {
    return std::abs(row.at_s - kidnap.at_s) < kSameTime;
  });
  if (found != rows.end()) return *found;
  const bool start = std::holds_alternative<UnknownStart>(kidnap.cause);
  const std::string kind = start ? "unknown start" : part_name(kidnap.cause);
  return rows.emplace_back(
      KidnapRow{kidnap.at_s, kind, {}, {}, std::vector<std::optional<SummaryKidnap>>(localizers)});
}

std::vector<KidnapRow> kidnap_rows(const RunFolder& run, const std::vector<std::string>& names) {
  std::vector<KidnapRow> rows = kidnap_events(run, names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    for (const SummaryKidnap& kidnap : summary_kidnaps(run.summary, names[k])) {
      row_for(kidnap, names.size(), rows).outcomes[k] = kidnap;
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const KidnapRow& a, const KidnapRow& b) { return a.at_s < b.at_s; });
  return rows;
}

std::string place_text(const MaybePose& pose) {
  return pose ? fmt::format("({:.2f}, {:.2f})", pose->x, pose->y) : readable(std::nullopt);
}

std::string distance_text(const KidnapRow& row) {
  if (!row.T_map_from || !row.T_map_to) return readable(std::nullopt);
  return readable(localization::distance(*row.T_map_from, *row.T_map_to), "m");
}

std::string outcome_html(const std::optional<SummaryKidnap>& outcome) {
  if (!outcome) return readable(std::nullopt);
  if (!outcome->scored) return "<span class=\"soft\">not scored</span>";
  if (outcome->recovered) return readable(outcome->time_s, "s");
  return fmt::format("<span class=\"bad\">not recovered</span>, lost for {}",
                     readable(outcome->lost_s, "s"));
}

std::string kidnap_cell(const std::string& head, const std::string& html) {
  return fmt::format("<td data-head=\"{}\"><span>{}</span></td>", escape_html(head), html);
}

std::string kidnap_row_html(const KidnapRow& row, const std::vector<std::string>& names) {
  std::string html =
      fmt::format("<tr data-time=\"{:.3f}\"><td>{}</td>", row.at_s, readable(row.at_s, "s")) +
      kidnap_cell("kidnap", escape_html(row.kind)) +
      kidnap_cell("from [m]", place_text(row.T_map_from)) +
      kidnap_cell("to [m]", place_text(row.T_map_to)) + kidnap_cell("distance", distance_text(row));
  for (std::size_t k = 0; k < names.size(); ++k) {
    html += kidnap_cell(names[k], outcome_html(row.outcomes[k]));
  }
  return html + "</tr>\n";
}

/// None without truth, where nothing is scored.
std::vector<std::string> scored_localizers(const RunFolder& run) {
  if (is_without_truth(run.summary)) return {};
  return summary_localizers(run.summary);
}

}  // namespace

std::string kidnap_section(const RunFolder& run) {
  const std::vector<std::string> names = scored_localizers(run);
  const std::vector<std::size_t> styles = localizer_styles(names);
  std::string body;
  for (const KidnapRow& row : kidnap_rows(run, names)) body += kidnap_row_html(row, names);
  if (body.empty()) return "";
  std::string head =
      "<th>time</th><th>kidnap</th><th>from [m]</th><th>to [m]</th><th>distance</th>";
  for (std::size_t k = 0; k < names.size(); ++k) {
    head += fmt::format("<th>{}{}</th>", line_sample(styles[k]), escape_html(names[k]));
  }
  return html_section(
      "Kidnaps", fmt::format("<div class=\"wide\"><table class=\"stack\"><thead><tr>{}</tr></thead>"
                             "<tbody>\n{}</tbody></table></div>\n",
                             head, body));
}

std::optional<double> opening_time(const RunFolder& run) {
  const std::vector<KidnapRow> rows = kidnap_rows(run, scored_localizers(run));
  const auto failure = std::find_if(rows.begin(), rows.end(),
                                    [](const KidnapRow& row) { return row.has_failure(); });
  if (failure != rows.end()) return failure->at_s;
  return rows.empty() ? std::nullopt : std::optional(rows.front().at_s);
}

}  // namespace castaway::testbed
