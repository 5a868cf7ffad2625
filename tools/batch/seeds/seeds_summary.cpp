#include "tools/batch/seeds/seeds_summary.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/figure_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/formats/text_table.hpp"
#include "tools/base/output/progress_line.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// A figure over seeds: mean with its interval.
std::string over_seeds(const Json& figures, const std::string& name, const char* format) {
  if (!figures.contains(name)) return "-";
  const Json& figure = figures.at(name);
  return figure_text(figure.at("mean"), format) + interval_text(figure.at("mean_interval"), format);
}

std::vector<std::string> seeds_row(const std::string& name, const Json& recovery,
                                   const Json& figures) {
  const Json& time = recovery.at("time_s");
  return {
      name,
      fmt::format("{} of {}{}", integer<int>(recovery.at("recovered")),
                  integer<int>(recovery.at("events")),
                  interval_text(recovery.at("success_interval"), "{:.0f} %", 100.0)),
      figure_text(time.at("mean"), "{:.2f}") + interval_text(time.at("mean_interval"), "{:.2f}"),
      figure_text(time.at("max"), "{:.2f} s"),
      over_seeds(figures, name + ".tracking_error_m.mean", "{:.4f}"),
      over_seeds(figures, name + ".wrong_lock_share", "{:.3f}")};
}

/// ", 2 void (seeds 3, 7) and left out"; empty if none is void.
std::string voids_text(const Json& summary) {
  if (!summary.contains("void_seeds") || summary.at("void_seeds").empty()) return "";
  std::string seeds;
  for (const Json& seed : summary.at("void_seeds")) {
    seeds += fmt::format("{}{}", seeds.empty() ? "" : ", ", integer<std::uint64_t>(seed));
  }
  return fmt::format(", {} void (seeds {}) and left out", summary.at("void_seeds").size(), seeds);
}

TextTable table_of(const Json& summary) {
  TextTable table{
      {"", "recovered", "recovery time [s]", "slowest", "tracking error [m]", "wrong, share"}, {}};
  for (const auto& [name, localizer] : summary.at("localizers").items()) {
    table.rows.push_back(seeds_row(name, localizer.at("recovery"), summary.at("figures")));
  }
  return table;
}

std::string counts_text(const Json& summary) {
  return fmt::format("{} seeds, {} failed{}", summary.at("seeds").size(),
                     summary.at("failed_seeds").size(), voids_text(summary));
}

/// Text in a line of Markdown.
std::string code(const std::string& text) {
  return text.find('`') == std::string::npos ? "`" + text + "`" : "`` " + text + " ``";
}

}  // namespace

std::string describe_seeds(const std::filesystem::path& folder) {
  const Json summary = read_json(folder / "summary.json");
  std::string text = fmt::format("{}: {}; means with 95 % intervals\n\n",
                                 summary.at("scenario").get<std::string>(), counts_text(summary));
  text += as_text(table_of(summary), columns_of(stdout));
  text +=
      fmt::format("\nRun folders: {0}/seed-<n>\nSummary:     {0}/summary.json\n", folder.string());
  const std::filesystem::path page = folder / "index.html";
  return std::filesystem::exists(page) ? text + fmt::format("Page:        {}\n", page.string())
                                       : text;
}

std::string seeds_markdown(const std::filesystem::path& folder, const SeedsVerdict& verdict) {
  const Json summary = read_json(folder / "summary.json");
  const auto met = std::ranges::count_if(verdict.checks, &Check::met);
  std::string text = fmt::format(
      "### {} {}\n\n{}; {} of {} expectations met. Means with 95 % "
      "intervals:\n\n{}",
      verdict.worst ? "❌" : "✅", summary.at("scenario").get<std::string>(), counts_text(summary),
      met, verdict.checks.size(), as_markdown(table_of(summary)));
  if (!verdict.worst) return text;
  text += "\n";
  for (const Check& check : verdict.checks) {
    if (!check.met) text += "* not met: " + code(describe(check)) + "\n";
  }
  return text + fmt::format("\nTo repeat seed {}: {}\n", *verdict.worst, code(verdict.repeats));
}

void RecoveryTally::add(const MetricTable& run) {
  constexpr std::string_view kEvents = ".recovery.events";
  for (const auto& [name, events] : run) {
    if (!name.ends_with(kEvents) || !events) continue;
    const std::string localizer = name.substr(0, name.size() - kEvents.size());
    auto& [recovered, all] = counts_[localizer];
    all += static_cast<int>(*events);
    recovered += static_cast<int>(run.at(localizer + ".recovery.recovered").value_or(0.0));
  }
}

std::string RecoveryTally::text() const {
  std::string text;
  for (const auto& [name, counts] : counts_) {
    if (counts.second == 0) continue;
    text +=
        fmt::format("{}{} {} of {}", text.empty() ? "" : ", ", name, counts.first, counts.second);
  }
  return text.empty() ? text : text + " recovered";
}

}  // namespace castaway::testbed
