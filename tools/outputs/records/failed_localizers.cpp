#include "tools/outputs/records/failed_localizers.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {

using Json = nlohmann::ordered_json;

Json failed_json(const std::vector<RunEvent>& events) {
  Json failed = Json::object();
  for (const RunEvent& event : events) {
    const auto* failure = event.as<FailureEvent>();
    if (failure == nullptr) continue;
    failed[failure->localizer] = {{"at_s", seconds(event.stamp)}, {"what", failure->reason}};
  }
  return failed;
}

std::vector<std::string> failure_sentences(const Json& summary) {
  std::vector<std::string> sentences;
  const auto failed = summary.find("failed");
  if (failed == summary.end() || !failed->is_object()) return sentences;
  for (const auto& [name, failure] : failed->items()) {
    sentences.push_back(
        fmt::format("{} failed at {:.1f} s: it {}. Its figures count the rest of "
                    "the run as wrong",
                    name, failure.value("at_s", 0.0), failure.value("what", "failed")));
  }
  return sentences;
}

}  // namespace castaway::testbed
