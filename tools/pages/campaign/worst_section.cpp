#include "tools/pages/campaign/worst_section.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/data_table.hpp"
#include "tools/pages/html/html_page.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// A word of a shell's command line.
std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=,:+";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// A link to what is kept of the cell, to the time of the kidnap if it has a player; empty if
/// nothing is kept.
std::string kept_link(const FinishedCampaign& campaign, const WorstKidnap& worst) {
  const std::string kept = fmt::format("cells/{:06d}-{}", worst.cell, worst.name);
  const double at_s = worst.kidnap.kidnap.at_s;
  if (fs::exists(campaign.folder / kept / "report.html")) {
    return fmt::format("<a href=\"{}/report.html#t={:.1f}\">report at {:.1f} s</a><br>", kept, at_s,
                       at_s);
  }
  if (!fs::is_directory(campaign.folder / kept)) return "";
  return fmt::format("<a href=\"{}/\">kept</a><br>", kept);
}

std::string values_text(const WorstKidnap& worst, const ValueLabels& labels) {
  std::string text;
  for (const auto& [key, value] : worst.values) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", key, labels.words(key, value));
  }
  return text;
}

std::vector<DataCell> worst_row(const FinishedCampaign& campaign, const CampaignFigures& figures,
                                const ValueLabels& labels, const WorstKidnap& worst) {
  const CellKidnap& kidnap = worst.kidnap.kidnap;
  const auto x = kidnap.T_map_to ? std::optional(kidnap.T_map_to->x) : std::nullopt;
  const auto y = kidnap.T_map_to ? std::optional(kidnap.T_map_to->y) : std::nullopt;
  const std::string command = replay_command(campaign, worst.cell);
  return {count_cell(worst.cell),
          {fmt::format("{}", worst.seed), static_cast<double>(worst.seed)},
          values_text(worst, labels),
          figures.series[worst.series].label,
          kidnap.kind,
          number_cell(kidnap.at_s),
          number_cell(x),
          number_cell(y),
          number_cell(worst.kidnap.lost_s),
          kidnap.recovered ? "yes" : "no",
          number_cell(worst.largest_error_m),
          {command, std::nullopt,
           kept_link(campaign, worst) + fmt::format("<code>{}</code><br>again/report.html#t={:.1f}",
                                                    escape_html(command), kidnap.at_s)}};
}

}  // namespace

std::string replay_command(const FinishedCampaign& campaign, int cell) {
  std::string command =
      "castaway campaign " + shell_word(fs::path(campaign.spec.file).filename().string());
  for (const std::string& assignment : campaign.overrides) {
    command += " --set " + shell_word(assignment);
  }
  if (campaign.spec.programs == FilePrograms::kAllowed) command += " --allow-programs";
  return command + fmt::format(" --only {} --out again", cell);
}

std::string worst_section(const FinishedCampaign& campaign, const CampaignFigures& figures) {
  DataTable table{"worst",
                  {"cell", "seed", "values", "localizer", "kidnap", "at [s]", "x [m]", "y [m]",
                   "lost for [s]", "recovered", "largest error [m]", "play again"},
                  {}};
  const ValueLabels labels(campaign.spec);
  for (const WorstKidnap& worst : figures.worst.kidnaps()) {
    table.rows.push_back(worst_row(campaign, figures, labels, worst));
  }
  return html_section(
      "Worst kidnaps",
      "<p class=\"soft\">The kidnaps after which a localizer was lost for longest, at most 200. "
      "The "
      "command plays the cell in full; the address below it opens the player at the kidnap.</p>\n" +
          data_table_html(table, "No kidnaps."));
}

}  // namespace castaway::testbed
