#include "tools/pages/run/report_words.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

std::string plural(std::int64_t count, const std::string& noun) {
  if (count == 0) return "no " + noun;
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The integer at a pointer; 0 if it is missing.
int whole_at(const Json& json, const char* pointer) {
  const Json::json_pointer path(pointer);
  return json.contains(path) ? integer<int>(json.at(path)) : 0;
}

std::int64_t count_kidnaps(const RunFolder& run) {
  return std::ranges::count_if(run.events, [](const ReportEvent& event) {
    return std::holds_alternative<KidnapEvent>(event.what);
  });
}

/// An additional sentence about unscored kidnaps; empty if every kidnap is scored.
std::string unscored_words(const Json& figures) {
  const auto recovery = figures.find("recovery");
  if (recovery == figures.end()) return "";
  const std::string sentence = unscored_sentence(*recovery);
  return sentence.empty() ? "" : " " + sentence + ".";
}

std::string recovery_words(const RunFolder& run, const Json& figures) {
  const auto events = whole_at(figures, "/recovery/events");
  const bool known_start = run.summary.value("known_start", true);
  if (events == 0) {
    if (unscored_words(figures).empty()) return "was never displaced";
    return known_start ? "was displaced" : "started at an unknown pose";
  }
  const auto recovered = whole_at(figures, "/recovery/recovered");
  std::string what = events == 1 ? "kidnap" : "kidnaps";
  if (!known_start) what = events == 1 ? "unknown start" : "losses (unknown start and kidnaps)";
  std::string words = fmt::format("recovered from {} of {} {}", recovered, events, what);
  const auto slowest = figure_at(figures, "/recovery/time_s/max");
  if (recovered > 1) {
    words += fmt::format(", slowest {}, median {}", readable(slowest, "s"),
                         readable(figure_at(figures, "/recovery/time_s/median"), "s"));
  } else if (recovered == 1) {
    words += fmt::format(", after {}", readable(slowest, "s"));
  }
  return words;
}

std::string error_words(const Json& figures) {
  const auto mean = figure_at(figures, "/tracking_error_m/mean");
  if (!mean) return "";
  return fmt::format(" While tracking, its position error was {} in the mean, 95 % below {}.",
                     readable(mean, "m"),
                     readable(figure_at(figures, "/tracking_error_m/p95"), "m"));
}

std::string lock_words(const Json& figures) {
  const auto share = figure_at(figures, "/wrong_lock_share");
  if (!share) return "";
  if (*share == 0.0) return " It never claimed to be right while it was wrong.";
  return fmt::format(" It claimed to be right while it was wrong in {} of the scans.",
                     readable(100.0 * *share, "%"));
}

std::string percent_at(const Json& figures, const char* pointer) {
  auto share = figure_at(figures, pointer);
  if (share) *share *= 100.0;
  return readable(share, "%");
}

/// What a localizer states itself, for runs without true poses.
std::string stated_words(const Json& figures) {
  std::string words = fmt::format(
      "answered {} of the scans, and stated a probability of {} in the mean, at least 0.99 in {}",
      percent_at(figures, "/stated/answered_share"),
      readable(figure_at(figures, "/stated/probability_mean")),
      percent_at(figures, "/stated/sure_share"));
  const int alarms = whole_at(figures, "/stated/alarms");
  words += alarms == 0 ? "; it never raised the alarm"
                       : fmt::format("; it raised the alarm {}, for {} at the longest",
                                     plural(alarms, "time"),
                                     readable(figure_at(figures, "/stated/longest_alarm_s"), "s"));
  const int jumps = whole_at(figures, "/jumps/count");
  return words + fmt::format(". Its output jumped {} against odometry", plural(jumps, "time"));
}

}  // namespace

std::optional<double> figure_at(const Json& json, const std::string& pointer) {
  const Json::json_pointer path(pointer);
  if (!json.contains(path) || !json.at(path).is_number()) return std::nullopt;
  return json.at(path).get<double>();
}

std::string describe_localizer(const RunFolder& run, const std::string& name) {
  const Json& figures = run.summary["localizers"][name];
  if (is_without_truth(run.summary)) {
    return fmt::format("<strong>{}</strong> {}.", escape_html(name), stated_words(figures));
  }
  return fmt::format("<strong>{}</strong> {}.{}{}{}", escape_html(name),
                     recovery_words(run, figures), unscored_words(figures), error_words(figures),
                     lock_words(figures));
}

std::string describe_run(const RunFolder& run) {
  const Json& summary = run.summary;
  return fmt::format(
      "World {}, robot {}, seed {}: {} driven in {}, {}, {}.",
      escape_html(summary.value("world", "?")), escape_html(summary.value("robot", "?")),
      integer_or(summary, "seed", std::uint64_t{0}),
      readable(figure_at(summary, "/distance_m"), "m"),
      readable(figure_at(summary, "/duration_s"), "s"), plural(count_kidnaps(run), "kidnap"),
      plural(integer_or(summary, "collisions", std::int64_t{0}), "collision"));
}

}  // namespace castaway::testbed
