#include "tools/report/report.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "tools/files/file.hpp"
#include "tools/metrics/void_run.hpp"
#include "tools/records/recording.hpp"
#include "tools/report/calibration_section.hpp"
#include "tools/report/curves_section.hpp"
#include "tools/report/html/html.hpp"
#include "tools/report/html/report_style.hpp"
#include "tools/report/map_plot.hpp"
#include "tools/report/pictures_section.hpp"
#include "tools/report/player_section.hpp"
#include "tools/report/report_tables.hpp"
#include "tools/report/report_words.hpp"

namespace castaway::testbed {
namespace {

/// Nothing is loaded from anywhere, whatever a page's texts hold.
constexpr const char* kPolicy =
    "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src "
    "'unsafe-inline'";

std::string lead(const RunFolder& run) {
  std::string html = "<div class=\"lead\">\n";
  if (const auto sentence = void_sentence(run.summary)) {
    html += fmt::format(
        "<p class=\"void\"><strong>Void:</strong> {}. The figures say nothing about "
        "localizers.</p>\n",
        escape_html(*sentence));
  }
  for (const auto& [name, figures] : run.summary["localizers"].items()) {
    html += fmt::format("<p>{}</p>\n", describe_localizer(run, name));
  }
  return html + fmt::format("</div>\n<p class=\"soft\">{}</p>\n", describe_run(run));
}

std::string calibration_section(const RunFolder& run) {
  const std::string html = calibration_html(run);
  return html.empty() ? "" : section("Stated probability", legend(run, false) + html);
}

std::string timing_section(const RunFolder& run) {
  if (run.timing.is_null()) return "";
  const std::string body = fmt::format(
      "<p class=\"soft\">Measured by a clock: the only part that differs from one repetition to "
      "the "
      "next.</p>\n{}",
      timing_tables(run));
  return fmt::format("<!-- timing: begin -->\n{}<!-- timing: end -->\n", section("Timing", body));
}

std::string head(const RunFolder& run, const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>castaway: {}</title><style>{}{}</style></head>\n",
      kPolicy, title, kReportStyle, player_style(run));
}

/// What a player shows, too, and better: hidden once it has started.
std::string still(const std::string& html) { return "<div class=\"still\">\n" + html + "</div>\n"; }

/// The map that the run was recorded with, if it was.
std::optional<RosMap> recorded_map(const RunFolder& run, const std::filesystem::path& folder) {
  if (run.recording.empty()) return std::nullopt;
  try {
    return map_of(unpack_recording(run.recording));
  } catch (const std::exception& error) {
    throw std::runtime_error((folder / "recording.gz").string() + ": " + error.what());
  }
}

}  // namespace

std::string render_report(const RunFolder& run, const std::optional<RosMap>& map) {
  const std::string title = escape_html(run.summary.value("scenario", "run"));
  return head(run, title) +
         fmt::format("<body><div id=\"castaway-theme-place\"></div>\n<h1>{}</h1>\n", title) +
         lead(run) + player_section(run) + section("Figures", metric_table(run)) +
         still(curves_section(run)) + calibration_section(run) +
         still(section("Path on the map", legend(run, true) + render_map_plot(run, map))) +
         section("Events", event_table(run)) + pictures_section(run) + player_scripts(run) +
         timing_section(run) + "</body></html>\n";
}

void write_report(const std::filesystem::path& run_folder, const std::optional<RosMap>& map) {
  const RunFolder run = load_run_folder(run_folder);
  write_file(run_folder / "report.html",
             render_report(run, map ? map : recorded_map(run, run_folder)));
}

}  // namespace castaway::testbed
