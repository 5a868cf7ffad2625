#include "tools/outputs/records/summary_kidnaps.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

SummaryKidnap kidnap_from(const Json& window) {
  SummaryKidnap kidnap;
  kidnap.cause = cause_named(window.at("kind").get<std::string>());
  kidnap.taken_s = window.at("taken_s").get<double>();
  kidnap.at_s = window.at("at_s").get<double>();
  kidnap.scored = window.at("scored").get<bool>();
  kidnap.recovered = window.at("recovered").get<bool>();
  if (window.at("time_s").is_number()) kidnap.time_s = window.at("time_s").get<double>();
  return kidnap;
}

}  // namespace

std::vector<SummaryKidnap> summary_kidnaps(const Json& summary, const std::string& localizer) {
  std::vector<SummaryKidnap> kidnaps;
  if (!summary.contains("localizers")) return kidnaps;
  const Json& localizers = summary.at("localizers");
  const auto found = localizers.find(localizer);
  if (found == localizers.end() || !found->contains("recovery")) return kidnaps;
  for (const Json& window : found->at("recovery").at("each")) {
    kidnaps.push_back(kidnap_from(window));
  }
  for (std::size_t i = 0; i < kidnaps.size(); ++i) {
    const bool last = i + 1 == kidnaps.size();
    const double end = last ? summary.value("duration_s", 0.0) : kidnaps[i + 1].taken_s;
    kidnaps[i].lost_s = kidnaps[i].time_s.value_or(std::max(0.0, end - kidnaps[i].at_s));
  }
  return kidnaps;
}

std::vector<std::string> summary_localizers(const Json& summary) {
  std::vector<std::string> names;
  if (!summary.contains("localizers")) return names;
  for (const auto& [name, figures] : summary.at("localizers").items()) names.push_back(name);
  return names;
}

}  // namespace castaway::testbed
