#include "tools/report/runs_page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/files/file.hpp"
#include "tools/formats/json_file.hpp"
#include "tools/formats/json_number.hpp"
#include "tools/metrics/void_run.hpp"
#include "tools/report/html/html.hpp"
#include "tools/report/html/html_page.hpp"
#include "tools/report/report_words.hpp"
#include "tools/report/run_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// Percent-encoded path of a file relative to a page.
std::string address(const fs::path& file, const fs::path& page) {
  const fs::path folder = fs::absolute(page).parent_path();
  std::string encoded;
  for (const char c : fs::absolute(file).lexically_relative(folder).generic_string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                       (byte >= '0' && byte <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    encoded += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return encoded;
}

std::string runs_cell(const std::string& text) { return "<td>" + text + "</td>"; }

/// One row per localizer; the first one also has the cells of the run.
std::string rows_of(const fs::path& folder, const fs::path& page) {
  const RunFolder run = load_run_folder(folder);
  const auto& localizers = run.summary["localizers"];
  std::string first = fmt::format("<td rowspan=\"{}\"><a href=\"{}\">{}, seed {}</a>{}</td>",
                                  std::max<std::size_t>(1, localizers.size()),
                                  address(folder / "report.html", page),
                                  escape_html(run.summary.value("scenario", "run")),
                                  integer_or(run.summary, "seed", std::uint64_t{0}),
                                  void_sentence(run.summary) ? "<br><strong>void</strong>" : "");
  std::string rows;
  for (const auto& [name, figures] : localizers.items()) {
    rows += "<tr>" + first + "<td class=\"words\">" + describe_localizer(run, name) + "</td>" +
            runs_cell(readable(figure_at(figures, "/position_error_m/median"), "m")) +
            runs_cell(readable(figure_at(figures, "/position_error_m/p95"), "m")) +
            runs_cell(readable(figure_at(figures, "/recovery/time_s/max"), "s")) + "</tr>\n";
    first.clear();
  }
  return rows.empty() ? "<tr>" + first + "<td colspan=\"4\">no localizer</td></tr>\n" : rows;
}

}  // namespace

std::string render_runs_page(const std::vector<fs::path>& folders, const fs::path& page) {
  const std::string title = fmt::format("{} runs", folders.size());
  std::string body = fmt::format(
      "<h1>{}</h1>\n<div class=\"wide\"><table><thead><tr><th>run</th><th>result</th><th>position "
      "error, "
      "median</th><th>95 % below</th><th>slowest recovery</th></tr></thead><tbody>\n",
      title);
  for (const fs::path& folder : folders) {
    read_fields(folder / "summary.json", [&] { body += rows_of(folder, page); });
  }
  return html_page({.title = title,
                    .body = body + "</tbody></table></div>",
                    .style = "td.words { white-space: normal; text-align: left; "
                             "min-width: 18rem; } td { vertical-align: top; }"});
}

void write_runs_page(const std::vector<fs::path>& folders, const fs::path& page) {
  write_file(page, render_runs_page(folders, page));
}

}  // namespace castaway::testbed
