#include "tools/pages/run/report.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/outputs/records/failed_localizers.hpp"
#include "tools/outputs/records/recording.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/run/calibration_section.hpp"
#include "tools/pages/run/curves_section.hpp"
#include "tools/pages/run/kidnap_section.hpp"
#include "tools/pages/run/player_section.hpp"
#include "tools/pages/run/repeat_section.hpp"
#include "tools/pages/run/report_tables.hpp"
#include "tools/pages/run/report_words.hpp"
#include "tools/pages/run/run_folder.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMaxPictures = 60;  // Keeps the page at about 5 MB.

bool is_by_time(const ReportPicture& picture) {
  return picture.name.find("-time-") != std::string::npos;
}

/// "t0032.100-kidnap-1-map.png": "32.100 s, kidnap 1, map".
std::string caption(const std::string& name) {
  const std::size_t first = name.find('-');
  const std::size_t last = name.rfind('-');
  const std::size_t digit = name.find_first_of("123456789.");
  if (name[0] != 't' || last <= first || digit >= first) return escape_html(name);
  const std::size_t begin = name[digit] == '.' ? digit - 1 : digit;
  std::string what = name.substr(first + 1, last - first - 1);
  std::replace(what.begin(), what.end(), '-', ' ');
  const std::string view = name.substr(last + 1, name.rfind('.') - last - 1);
  return escape_html(fmt::format("{} s, {}, {}", name.substr(begin, first - begin), what, view));
}

/// The pictures with captions, or the reason why there are none. If there are too many, those of
/// kidnaps and recoveries are preferred.
std::string pictures_section(const RunFolder& run) {
  if (run.pictures.empty()) {
    const std::string reason = run.pictures_missing.value_or("none was asked for");
    return html_section("Pictures",
                        fmt::format("<p>There are no pictures: {}</p>\n", escape_html(reason)));
  }
  std::string html =
      "<p class=\"soft\">On the map: the truth in black, each localizer in its colour, its "
      "particles in shades of it, one a population. In the room: lidar hits in red.</p>\n"
      "<div class=\"pictures\">";
  const bool drop_by_time = run.pictures.size() > kMaxPictures;
  std::size_t shown = 0;
  for (const ReportPicture& picture : run.pictures) {
    if (shown == kMaxPictures || (drop_by_time && is_by_time(picture))) continue;
    ++shown;
    html +=
        fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                    caption(picture.name), png_data_uri(picture.png));
  }
  html += "</div>\n";
  if (shown < run.pictures.size()) {
    html += fmt::format("<p class=\"soft\">{} more in the folder snapshots.</p>\n",
                        run.pictures.size() - shown);
  }
  return html_section("Pictures", html);
}

std::string lead_text(const RunFolder& run) {
  std::string html = "<div class=\"lead\">\n";
  if (const auto sentence = void_sentence(run.summary)) {
    html += fmt::format(
        "<p class=\"void\"><strong>Void:</strong> {}. The figures say nothing about "
        "localizers.</p>\n",
        escape_html(*sentence));
  }
  for (const std::string& sentence : failure_sentences(run.summary)) {
    html += fmt::format("<p class=\"void\">{}.</p>\n", escape_html(sentence));
  }
  if (is_without_truth(run.summary)) {
    html +=
        "<p>The log holds no true poses, so that nothing is scored. This is what the localizers "
        "state themselves.</p>\n";
  }
  for (const auto& [name, figures] : run.summary["localizers"].items()) {
    html += fmt::format("<p>{}</p>\n", describe_localizer(run, name));
  }
  html += fmt::format(
      "</div>\n<p class=\"soft\">{} castaway {}<span id=\"castaway-made-place\"></span></p>\n",
      describe_run(run), escape_html(run.summary.value("castaway", "?")));
  for (const auto& note : run.summary.value("notes", nlohmann::ordered_json::array())) {
    html += fmt::format("<p class=\"soft\">Note: {}.</p>\n", escape_html(note.get<std::string>()));
  }
  return html;
}

std::string calibration_section(const RunFolder& run) {
  if (is_without_truth(run.summary)) return "";
  const std::string html = calibration_html(run);
  return html.empty() ? "" : html_section("Stated probability", html);
}

std::string path_section(const RunFolder& run, const ReportMaps& maps) {
  if (is_without_truth(run.summary)) {
    return html_section("Paths on the map", render_map_plot(run, maps));
  }
  return html_section("Error along the path",
                      "<p class=\"soft\">The true path in the colours of the error, the "
                      "localizer's own path as a thin line. ▼: where a kidnap put the robot; ✓: "
                      "where the localizer was right again.</p>\n" +
                          render_map_plot(run, maps));
}

/// When and where the run was made; the page's script shows it at its head, too.
std::string made_text(const RunFolder& run) {
  if (!run.timing.contains("made")) return "";
  const auto& made = run.timing.at("made");
  const std::string commit = made.value("commit", "");
  return fmt::format("<p id=\"castaway-made\">made on {}, {}{}</p>\n",
                     escape_html(made.value("date", "?")), escape_html(made.value("machine", "?")),
                     commit.empty() ? "" : ", at commit " + escape_html(commit));
}

std::string timing_section(const RunFolder& run) {
  if (run.timing.is_null()) return "";
  const std::string body = fmt::format(
      "<p class=\"soft\">Measured by a clock: the only part that differs from one repetition to "
      "the "
      "next.</p>\n{}{}",
      made_text(run), timing_tables(run));
  return fmt::format("<!-- timing: begin -->\n{}<!-- timing: end -->\n",
                     html_section("Timing", body));
}

/// The maps in the run's recording, if there is one.
ReportMaps recorded_maps(const RunFolder& run, const std::filesystem::path& folder) {
  if (run.recording.empty()) return {};
  try {
    const Recording recording = unpack_recording(run.recording);
    return {map_of(recording), levels_of(recording)};
  } catch (const std::exception& error) {
    throw std::runtime_error((folder / "recording.gz").string() + ": " + error.what());
  }
}

}  // namespace

std::string render_report(const RunFolder& run, const ReportMaps& maps) {
  const std::string title = run.summary.value("scenario", "run");
  const bool player = has_player(run);
  const std::string body = "<div id=\"castaway-theme-place\"></div>\n<h1>" + escape_html(title) +
                           "</h1>\n" + lead_text(run) + player_section(run) + kidnap_section(run) +
                           player_curves(run) + html_section("Figures", metric_table(run)) +
                           expectations_section(run) + (player ? "" : curves_section(run)) +
                           path_section(run, maps) + calibration_section(run) +
                           html_section("Events", event_table(run)) + pictures_section(run) +
                           repeat_section(run) + player_data(run) + timing_section(run);
  return html_page(
      {.title = title, .body = body, .bundle = player ? player_bundle() : plots_bundle()});
}

void write_report(const std::filesystem::path& run_folder, const ReportMaps& maps) {
  const RunFolder run = load_run_folder(run_folder);
  write_file(run_folder / "report.html",
             render_report(run, maps.map ? maps : recorded_maps(run, run_folder)));
}

void remake_report(const std::filesystem::path& run_folder) {
  const std::filesystem::path page = run_folder / "report.html";
  require_own_file(page);
  read_fields(run_folder / "summary.json", [&] {
    const RunFolder run = load_run_folder(run_folder);
    write_own_file(page, render_report(run, recorded_maps(run, run_folder)));
  });
}

}  // namespace castaway::testbed
