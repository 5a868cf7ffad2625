#include "tools/pages/runs/runs_table.hpp"

#include <string_view>

#include <fmt/format.h>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/pages/run/report_words.hpp"

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

DataCell bad_cell(const std::string& text, std::optional<double> value) {
  return {text, value, "<span class=\"bad\">" + escape_html(text) + "</span>"};
}

/// Kidnaps of a run and recoveries from them.
struct Recoveries {
  int events = 0;
  int recovered = 0;

  [[nodiscard]] int missed() const { return events - recovered; }
};

Recoveries recoveries_of(const SetRun& run, const std::string& localizer) {
  const auto& localizers = run.summary.at("localizers");
  const auto found = localizers.find(localizer);
  if (found == localizers.end() || !found->contains("recovery")) return {};
  const auto& recovery = found->at("recovery");
  return {integer<int>(recovery.at("events")), integer<int>(recovery.at("recovered"))};
}

DataCell recovered_cell(const Recoveries& recoveries) {
  if (recoveries.events == 0) return number_cell(std::nullopt);
  const std::string text = fmt::format("{} of {}", recoveries.recovered, recoveries.events);
  if (recoveries.missed() > 0) return bad_cell(text, recoveries.recovered);
  return {text, recoveries.recovered};
}

/// What went wrong in a run, in one cell.
DataCell trouble_cell(const RunSet& set, const SetRun& run) {
  if (run.is_void) return bad_cell("void", std::nullopt);
  int missed = 0;
  for (const std::string& name : set.localizers) missed += recoveries_of(run, name).missed();
  return missed > 0 ? bad_cell(fmt::format("{}", missed), missed) : count_cell(0);
}

std::vector<DataCell> localizer_cells(const SetRun& run, const std::string& name) {
  const auto& localizers = run.summary.at("localizers");
  const auto found = localizers.find(name);
  if (run.is_void || found == localizers.end()) return {"–", "–", "–"};
  return {recovered_cell(recoveries_of(run, name)),
          number_cell(figure_at(*found, "/recovery/time_s/max")),
          number_cell(figure_at(*found, "/tracking_error_m/mean"))};
}

std::vector<DataCell> run_row(const RunSet& set, const SetRun& run, const fs::path& page) {
  const std::string seed = fmt::format("{}", run.seed);
  std::vector<DataCell> row{
      {seed, static_cast<double>(run.seed),
       fmt::format("<a href=\"{}\">seed {}</a>", address(run.folder / "report.html", page), seed)}};
  if (!set.is_one_scenario()) row.emplace_back(run.scenario);
  row.push_back(trouble_cell(set, run));
  for (const std::string& name : set.localizers) {
    for (DataCell& cell : localizer_cells(run, name)) row.push_back(std::move(cell));
  }
  return row;
}

std::vector<DataCell> failed_row(std::uint64_t seed, std::size_t columns) {
  std::vector<DataCell> row{{fmt::format("seed {}", seed), static_cast<double>(seed)},
                            bad_cell("run failed", std::nullopt)};
  while (row.size() < columns) row.emplace_back("–");
  return row;
}

}  // namespace

DataTable runs_table(const RunSet& set, const std::vector<std::uint64_t>& failed_seeds,
                     const fs::path& page) {
  DataTable table{"runs", {"seed"}, {}};
  if (!set.is_one_scenario()) table.head.emplace_back("scenario");
  table.head.emplace_back("not recovered");
  for (const std::string& name : set.localizers) {
    table.head.push_back(name + " recovered");
    table.head.push_back(name + " slowest [s]");
    table.head.push_back(name + " tracking error [m]");
  }
  for (const SetRun& run : set.runs) table.rows.push_back(run_row(set, run, page));
  for (const std::uint64_t seed : failed_seeds) {
    table.rows.push_back(failed_row(seed, table.head.size()));
  }
  return table;
}

}  // namespace castaway::testbed
