#include "tools/batch/trials/kidnap_text.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/batch/trials/packed_values.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json packed_pose(const SE2& pose) { return {packed(pose.x), packed(pose.y), packed(pose.yaw)}; }

SE2 unpacked_pose(const Json& json) {
  return {unpacked_double(json.at(0)), unpacked_double(json.at(1)), unpacked_double(json.at(2))};
}

Json packed_scans(const WrongScans& scans) { return {scans.scans, scans.wrong, scans.longest_s}; }

WrongScans unpacked_scans(const Json& json) {
  return {json.at(0).get<std::int64_t>(), json.at(1).get<std::int64_t>(), json.at(2).get<double>()};
}

Json packed_errors(const std::vector<PoseError>& errors) {
  Json json = Json::array();
  for (const PoseError& error : errors)
    json.push_back({packed(error.position_m), packed(error.yaw_rad)});
  return json;
}

std::vector<PoseError> unpacked_errors(const Json& json) {
  std::vector<PoseError> errors;
  for (const Json& error : json) {
    errors.push_back({unpacked_double(error.at(0)), unpacked_double(error.at(1))});
  }
  return errors;
}

Json packed_outcome(const KidnapOutcome& outcome) {
  return {packed(outcome.recovered_s),
          packed(outcome.confident_s),
          packed(outcome.alarm_s),
          packed(outcome.noticed_s),
          packed_errors(outcome.tracking),
          packed_scans(outcome.since_kidnap),
          packed_scans(outcome.since_distinguishable),
          packed(outcome.calibration)};
}

KidnapOutcome unpacked_outcome(const Json& json) {
  KidnapOutcome outcome;
  outcome.recovered_s = unpacked_number(json.at(0));
  outcome.confident_s = unpacked_number(json.at(1));
  outcome.alarm_s = unpacked_number(json.at(2));
  outcome.noticed_s = unpacked_number(json.at(3));
  outcome.tracking = unpacked_errors(json.at(4));
  outcome.since_kidnap = unpacked_scans(json.at(5));
  outcome.since_distinguishable = unpacked_scans(json.at(6));
  outcome.calibration = unpacked_calibration(json.at(7));
  return outcome;
}

Json packed_search(const SearchOutcome& search) {
  return {search.rank ? Json(*search.rank) : Json(), packed(search.blocked_share),
          packed(search.right), packed(search.fifth)};
}

SearchOutcome unpacked_search(const Json& json) {
  SearchOutcome search;
  if (!json.at(0).is_null()) search.rank = json.at(0).get<std::size_t>();
  search.blocked_share = unpacked_double(json.at(1));
  search.right = unpacked_double(json.at(2));
  search.fifth = unpacked_double(json.at(3));
  return search;
}

}  // namespace

std::string pack_report(const KidnapReport& report) {
  Json outcomes = Json::array();
  for (const KidnapOutcome& outcome : report.outcomes) outcomes.push_back(packed_outcome(outcome));
  Json json = {{"index", report.index},
               {"obstacles", report.obstacles},
               {"from", packed_pose(report.T_map_from)},
               {"to", packed_pose(report.T_map_to)},
               {"search", packed_search(report.search)},
               {"outcomes", std::move(outcomes)}};
  if (report.void_run) json["void"] = {part_name(report.void_run->reason), report.void_run->at_s};
  if (report.distinguishable) json["distinguishable_ns"] = report.distinguishable->count();
  return json_text(json);
}

KidnapReport unpack_report(const std::string& text) try {
  const Json json = Json::parse(text);
  KidnapReport report;
  report.index = json.at("index").get<int>();
  report.obstacles = json.at("obstacles").get<int>();
  report.T_map_from = unpacked_pose(json.at("from"));
  report.T_map_to = unpacked_pose(json.at("to"));
  report.search = unpacked_search(json.at("search"));
  for (const Json& outcome : json.at("outcomes")) {
    report.outcomes.push_back(unpacked_outcome(outcome));
  }
  if (json.contains("void")) {
    const Json& run = json.at("void");
    report.void_run =
        VoidRun{void_reason_named(run.at(0).get<std::string>()), run.at(1).get<double>()};
  }
  if (json.contains("distinguishable_ns")) {
    report.distinguishable = Stamp(json.at("distinguishable_ns").get<std::int64_t>());
  }
  return report;
} catch (const Json::exception& error) {
  throw std::runtime_error(std::string("not the report of a trial: ") + error.what());
}

}  // namespace castaway::testbed
