#include "tools/run/metrics/void_run.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/formats/json_file.hpp"
#include "tools/run/event_names.hpp"
#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {

using Json = nlohmann::ordered_json;

std::optional<VoidRun> void_run(const std::vector<RunEvent>& events) {
  const auto found = std::find_if(events.begin(), events.end(),
                                  [](const RunEvent& event) { return event.is<VoidEvent>(); });
  if (found == events.end()) return std::nullopt;
  return VoidRun{found->as<VoidEvent>()->reason, seconds(found->begun())};
}

std::string describe(const VoidRun& run) {
  const auto* reason = std::get_if<sim::VoidReason>(&run.reason);
  if (reason != nullptr && *reason == sim::VoidReason::kContactFromStart) {
    return "the robot touches something from the start: it stands in an obstacle, or a part of it "
           "sticks out";
  }
  if (reason != nullptr && *reason == sim::VoidReason::kNeverMoved) {
    return "the robot never moved, although it had to drive";
  }
  return fmt::format("the robot was stuck from {:.1f} s on", run.at_s);
}

Json void_json(const std::optional<VoidRun>& run) {
  if (!run) return nullptr;
  return {{"reason", part_name(run->reason)}, {"sentence", describe(*run)}, {"at_s", run->at_s}};
}

std::optional<std::string> void_sentence(const Json& summary) {
  const auto found = summary.find("void");
  if (found == summary.end() || !found->is_object()) return std::nullopt;
  const auto sentence = found->find("sentence");
  return sentence != found->end() && sentence->is_string() ? sentence->get<std::string>()
                                                           : std::string("void");
}

std::optional<std::string> void_sentence_of(const std::filesystem::path& run_folder) {
  return void_sentence(read_json(run_folder / "summary.json"));
}

bool is_without_truth(const nlohmann::ordered_json& summary) {
  const auto share = summary.find("truth_share");
  return share != summary.end() && share->is_number() && share->get<double>() == 0.0;
}

std::string unscored_sentence(const nlohmann::ordered_json& recovery) {
  const auto each = recovery.find("each");
  if (each == recovery.end() || !each->is_array()) return "";
  int count = 0;
  const char* noun = "kidnap";
  for (const auto& event : *each) {
    if (!event.is_object() || event.value("scored", true)) continue;
    const LossCause cause = cause_named(event.value("kind", ""));
    if (std::holds_alternative<OrderedStart>(cause)) continue;
    ++count;
    if (std::holds_alternative<UnknownStart>(cause)) noun = "event";
  }
  if (count == 0) return "";
  return fmt::format(
      "{} {}{} not scored: less than {:.0f} s before the next one, an operator's order, or the "
      "end of the run",
      count, noun, count == 1 ? " is" : "s are", seconds(RecoveryConfig{}.min_left));
}

}  // namespace castaway::testbed
