#include "tools/batch/campaign/cell_row.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/batch/jobs/row_line.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

CellOutcome parse_state(const std::string& text) {
  for (const CellOutcome state : {CellOutcome::kDone, CellOutcome::kVoid, CellOutcome::kFailed}) {
    if (to_string(state) == text) return state;
  }
  throw std::runtime_error("no state '" + text + "'");
}

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::optional<double> optional_of(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

Json kidnap_json(const CellKidnap& kidnap) {
  Json pose;
  if (kidnap.T_map_to) pose = {kidnap.T_map_to->x, kidnap.T_map_to->y, kidnap.T_map_to->yaw};
  return {kidnap.localizer,
          kidnap.kind,
          kidnap.at_s,
          pose,
          kidnap.scored,
          kidnap.recovered,
          optional_json(kidnap.time_s)};
}

CellKidnap kidnap_of(const Json& json) {
  CellKidnap kidnap;
  kidnap.localizer = json.at(0).get<std::string>();
  kidnap.kind = json.at(1).get<std::string>();
  kidnap.at_s = json.at(2).get<double>();
  const Json& pose = json.at(3);
  if (!pose.is_null()) {
    kidnap.T_map_to =
        SE2{pose.at(0).get<double>(), pose.at(1).get<double>(), pose.at(2).get<double>()};
  }
  kidnap.scored = json.at(4).get<bool>();
  kidnap.recovered = json.at(5).get<bool>();
  kidnap.time_s = optional_of(json.at(6));
  return kidnap;
}

CellRow row_of(const Json& json) {
  CellRow row;
  row.index = json.at("index").get<int>();
  row.cell = json.at("cell").get<std::string>();
  row.seed = json.at("seed").get<std::uint64_t>();
  for (const Json& pair : json.at("values")) {
    row.values.emplace_back(pair.at(0).get<std::string>(), pair.at(1).get<std::string>());
  }
  row.state = parse_state(json.at("state").get<std::string>());
  row.reason = json.at("reason").get<std::string>();
  for (const auto& [name, value] : json.at("metrics").items()) {
    row.metrics[name] = optional_of(value);
  }
  for (const Json& kidnap : json.at("kidnaps")) row.kidnaps.push_back(kidnap_of(kidnap));
  row.cpu_s = json.at("cpu_s").get<double>();
  row.wall_s = json.at("wall_s").get<double>();
  row.memory_mb = json.at("memory_mb").get<double>();
  return row;
}

}  // namespace

std::string to_string(CellOutcome state) {
  switch (state) {
    case CellOutcome::kDone:
      return "done";
    case CellOutcome::kVoid:
      return "void";
    case CellOutcome::kFailed:
      return "failed";
  }
  return "";
}

std::optional<double> number_of(const std::string& value) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool whole = error == std::errc{} && end == value.data() + value.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string row_text(const CellRow& row) {
  Json values = Json::array();
  for (const auto& [key, value] : row.values) values.push_back({key, value});
  Json metrics = Json::object();
  for (const auto& [name, value] : row.metrics) metrics[name] = optional_json(value);
  Json kidnaps = Json::array();
  for (const CellKidnap& kidnap : row.kidnaps) kidnaps.push_back(kidnap_json(kidnap));
  const Json json{{"index", row.index},
                  {"cell", row.cell},
                  {"seed", row.seed},
                  {"values", values},
                  {"state", to_string(row.state)},
                  {"reason", row.reason},
                  {"metrics", metrics},
                  {"kidnaps", kidnaps},
                  {"cpu_s", row.cpu_s},
                  {"wall_s", row.wall_s},
                  {"memory_mb", row.memory_mb}};
  return row_line(json);
}

CellRow parse_row(const std::string& line) {
  const Json fields = parse_row_line(line);
  try {
    return row_of(fields);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("is no row of a campaign: ") + error.what());
  }
}

}  // namespace castaway::testbed
