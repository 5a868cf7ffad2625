#include "tools/play/run_summary.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/formats/figure_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/formats/text_table.hpp"
#include "tools/base/output/progress_line.hpp"
#include "tools/outputs/records/failed_localizers.hpp"
#include "tools/play/terminal.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// "0.15 s, 0.17 s": two figures of an object; "-" if it is none.
std::string two(const Json& object, const char* first, const char* second, const char* format) {
  if (!object.is_object() || object.at(first).is_null()) return "-";
  return figure_text(object.at(first), format) + ", " + figure_text(object.at(second), format);
}

/// A share of 1 in percent; "-" if there is none.
std::string percent(const Json& share) {
  return figure_text(share.is_number() ? Json(100.0 * share.get<double>()) : Json(), "{:.1f} %");
}

std::vector<std::string> scored_row(const std::string& name, const Json& metrics,
                                    const Json& timing) {
  const Json& recovery = metrics.at("recovery");
  const int recovered = integer<int>(recovery.at("recovered"));
  const int events = integer<int>(recovery.at("events"));
  const std::string share = fmt::format("{} of {}", recovered, events);
  const Json update = timing.contains(name) ? timing.at(name).at("update_ms") : Json();
  return {
      name,
      events == 0 ? share : paint(share, recovered < events ? Color::kRed : Color::kGreen, stdout),
      two(recovery.at("time_s"), "mean", "max", "{:.2f} s"),
      two(metrics.at("tracking_error_m"), "mean", "p95", "{:.3f} m"),
      percent(metrics.at("wrong_lock_share")),
      figure_text(metrics.at("calibration").at("brier"), "{:.3f}"),
      two(update, "mean", "max", "{:.2f} ms")};
}

/// "mh_amcl 98.2 %, amcl 71.0 %": the share of scans in which the others say the same.
std::string agreements(const Json& stated) {
  std::string text;
  if (!stated.contains("agreement")) return "-";
  for (const auto& [other, share] : stated.at("agreement").items()) {
    text += (text.empty() ? "" : ", ") + other + " " + percent(share);
  }
  return text;
}

std::vector<std::string> stated_row(const std::string& name, const Json& metrics) {
  const Json& stated = metrics.at("stated");
  return {name,
          percent(stated.at("answered_share")),
          figure_text(stated.at("probability_mean"), "{:.3f}"),
          percent(stated.at("sure_share")),
          percent(stated.at("alarm_share")),
          std::to_string(integer<int>(stated.at("alarms"))),
          figure_text(stated.at("longest_alarm_s"), "{:.1f} s"),
          percent(stated.at("steady_share")),
          agreements(stated)};
}

/// What localizers state themselves, for runs without true poses.
std::string stated_table(const Json& summary) {
  TextTable table{{"", "answered", "stated p", "sure", "in alarm", "alarms", "longest", "steady",
                   "agrees with"},
                  {}};
  for (const auto& [name, metrics] : summary.at("localizers").items()) {
    table.rows.push_back(stated_row(name, metrics));
  }
  return "No true poses: nothing is scored. What the localizers state themselves:\n\n" +
         as_text(table, columns_of(stdout));
}

std::string scored_table(const Json& summary, const Json& timing) {
  TextTable table{{"", "recovered", "recovery mean, max", "tracking mean, p95", "wrong", "Brier",
                   "update mean, max"},
                  {}};
  for (const auto& [name, metrics] : summary.at("localizers").items()) {
    table.rows.push_back(scored_row(name, metrics, timing.at("localizers")));
  }
  return as_text(table, columns_of(stdout));
}

/// The closest approach of people; empty if there were none.
std::string people_line(const Json& summary) {
  if (!summary.contains("people")) return "";
  const Json& people = summary.at("people");
  const Json& beams = people.at("beams_on_people");
  return fmt::format(
      "{} people: {} hit, closest {:.2f} m, within 0.45 m {} times, within 1.2 m {} times; on them "
      "{:.1f} % of the beams, at most {:.1f} %\n\n",
      integer<int>(people.at("people")), integer<int>(people.at("collisions")),
      people.at("closest_m").get<double>(), integer<int>(people.at("intimate").at("intrusions")),
      integer<int>(people.at("personal").at("intrusions")), 100.0 * beams.at("mean").get<double>(),
      100.0 * beams.at("max").get<double>());
}

/// How much the world differs from its map; empty if it does not.
std::string difference_line(const Json& summary) {
  if (!summary.contains("difference")) return "";
  const Json& difference = summary.at("difference");
  return fmt::format(
      "The world is not as mapped: {:.1f} % of the beams end elsewhere; {} moved, {} gone, {} new, "
      "{} doors opened, {} closed\n\n",
      100.0 * difference.at("beams").get<double>(), integer<int>(difference.at("moved")),
      integer<int>(difference.at("removed")), integer<int>(difference.at("added")),
      integer<int>(difference.at("opened")), integer<int>(difference.at("closed")));
}

/// How the run is otherwise than what it simulates; empty if it is not.
std::string note_lines(const Json& summary) {
  std::string text;
  for (const Json& note : summary.value("notes", Json::array())) {
    text += fmt::format("Note: {}.\n\n", note.get<std::string>());
  }
  return text;
}

/// What stopped the robot; empty if nothing did.
std::string driving_line(const Json& summary) {
  if (!summary.contains("driving")) return "";
  std::string text;
  for (const auto& [what, count] : summary.at("driving").items()) {
    if (integer<int>(count) == 0 || what == "recoveries") continue;
    text += fmt::format("{}{} {}", text.empty() ? "driving: " : ", ", integer<int>(count), what);
  }
  return text.empty() ? text : text + "\n\n";
}

/// What became of the scans that were sent to nodes of ROS 2; empty if there are none.
std::string answer_lines(const Json& summary) {
  std::string text;
  for (const auto& [name, metrics] : summary.at("localizers").items()) {
    if (!metrics.contains("answers")) continue;
    const Json& answers = metrics.at("answers");
    const auto count = [&](const char* what) { return integer<std::int64_t>(answers.at(what)); };
    text += fmt::format("\n{}: {} of {} scans answered, {} missing; {} answers late, {} doubled",
                        name, count("answered"), count("sent"), count("missing"), count("late"),
                        count("doubled"));
    if (count("malformed") > 0) text += fmt::format(", {} malformed", count("malformed"));
    text += "\n";
  }
  return text;
}

/// Kidnaps that are not scored; empty if all are.
std::string unscored_line(const Json& summary) {
  const Json& localizers = summary.at("localizers");
  if (localizers.empty()) return "";
  const std::string sentence = unscored_sentence(localizers.begin()->at("recovery"));
  return sentence.empty() ? "" : "\n" + sentence + "\n";
}

std::string cost_line(const Json& timing) {
  const Json& factor = timing.at("realtime_factor");
  const bool fast = factor.is_number() && factor.get<double>() >= 10.0;
  std::string text = fmt::format("\n{} x real time ({} wall, {} of it to load). CPU:",
                                 figure_text(factor, fast ? "{:.0f}" : "{:.2g}"),
                                 figure_text(timing.at("wall_s"), "{:.2f} s"),
                                 figure_text(timing.at("load_s"), "{:.2f} s"));
  const char* separator = " ";
  for (const auto& [stage, time] : timing.at("cpu_s").items()) {
    text += fmt::format("{}{} {}", separator, stage, figure_text(time, "{:.2f} s"));
    separator = ", ";
  }
  return text + "\n";
}

}  // namespace

std::string describe_run(const std::filesystem::path& run_folder) {
  const Json summary = read_json(run_folder / "summary.json");
  const Json timing = read_json(run_folder / "timing.json");
  std::string text = fmt::format(
      "{}, seed {}: {:.1f} s, {} driven, {} collisions\n\n",
      summary.at("scenario").get<std::string>(), integer<std::uint64_t>(summary.at("seed")),
      summary.at("duration_s").get<double>(), figure_text(summary.at("distance_m"), "{:.1f} m"),
      integer<int>(summary.at("collisions")));
  if (const auto sentence = void_sentence(summary)) {
    text += fmt::format("VOID: {}. The figures below say nothing about localizers.\n\n", *sentence);
  }
  if (const auto every = summary.find("scored_every"); every != summary.end()) {
    text += fmt::format("A long run: one scan in {} is scored.\n\n", integer<int>(*every));
  }
  text += note_lines(summary);
  text += difference_line(summary);
  text += people_line(summary);
  text += driving_line(summary);
  text += is_without_truth(summary) ? stated_table(summary) : scored_table(summary, timing);
  for (const std::string& sentence : failure_sentences(summary)) text += "\n" + sentence + ".\n";
  text += answer_lines(summary);
  text += unscored_line(summary);
  text += cost_line(timing);
  text += fmt::format("\nRun folder: {}\n", run_folder.string());
  const std::filesystem::path report = run_folder / "report.html";
  if (std::filesystem::exists(report)) text += fmt::format("Report:     {}\n", report.string());
  return text;
}

}  // namespace castaway::testbed
