#include "tools/play/replay/replay_session.hpp"

#include <algorithm>
#include <utility>

#include "tools/scenario/localizers/localizer_specs.hpp"
#include "tools/scenario/sections/operator_events.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

using Scans = CarmenSourceConfig::Scans;

/// A number of scans.
std::size_t read_count(YamlReader& body, const std::string& key) {
  return static_cast<std::size_t>(body.require<std::uint64_t>(key));
}

Scans read_scans_used(YamlReader& root) {
  const std::string text = root.choice("scans_used", "all", {"all", "even", "odd"});
  return text == "all" ? Scans::kAll : text == "even" ? Scans::kEven : Scans::kOdd;
}

BagTopicOptions read_topics(YamlReader& root) {
  BagTopicOptions topics;
  topics.scans = root.get("scan_topics", std::vector<std::string>{});
  topics.odometry = root.get("odom_topic", "");
  topics.truth = root.get("truth_topic", "");
  topics.clouds =
      root.get_optional<std::vector<std::string>>("points_topics").value_or(topics.clouds);
  topics.imu = root.get_optional<std::string>("imu_topic").value_or("");
  topics.clock_offset = root.get_optional<double>("clock_offset").value_or(0.0);
  return topics;
}

void read_session_events(YamlReader& root, ReplaySession& session) {
  for (YamlReader event : root.list("events")) {
    auto [kind, body] = event.name_and_body();
    if (kind == "splice") {
      session.part.jumps.push_back({read_count(body, "after_scans"), read_count(body, "to_scan")});
    } else if (kind == "localizer") {
      session.orders.push_back(read_localizer_order(body));
    } else {
      event.fail("unknown event '" + kind + "' of a replay; known: localizer, splice");
    }
  }
  std::ranges::stable_sort(session.orders, {}, &LocalizerOrder::at);
}

void check_session_orders(const YamlReader& root, const ReplaySession& session) {
  const std::vector<std::string> names = names_of(session.localizers);
  for (const LocalizerOrder& order : session.orders) {
    if (std::ranges::find(names, order.localizer) != names.end()) continue;
    root.fail("an event is for localizer '" + order.localizer + "'; " +
              suggestion(order.localizer, names));
  }
}

/// Localizers are read after it: its presence decides which one is the default.
std::string read_map3d(YamlDocument& document) {
  YamlReader root = document.root();
  std::string map3d = root.get_optional<std::string>("map3d").value_or("");
  if (!root.has("localizers")) {
    document.set(map3d.empty() ? "localizers=[mh_amcl]" : "localizers=[{mh_amcl: {mode: 3d}}]");
  }
  return map3d;
}

void check_map3d(const YamlReader& root, const ReplaySession& session) {
  if (session.map3d.empty() || std::ranges::any_of(session.localizers, is_on_map3d)) return;
  root.fail(
      "'map3d' (--map3d) is for mh_amcl in mode 3d, and no localizer of the replay is: add "
      "mh_amcl:3d, or leave the 3-D map out");
}

}  // namespace

ReplaySession read_session(YamlDocument document, const ForeignRules& rules) {
  ReplaySession session;
  session.map3d = read_map3d(document);
  YamlReader root = document.root();
  session.log = root.require<std::string>("log");
  session.map = root.get("map", "");
  session.known_start = root.choice("start", "unknown", {"truth", "unknown"}) == "truth";
  session.part.from_scan = static_cast<std::size_t>(root.get("from_scan", std::uint64_t{0}));
  if (root.has("scans")) session.part.scans = read_count(root, "scans");
  if (session.part.scans == 0U) root.fail("'scans' is 0: play at least one");
  session.scans_used = read_scans_used(root);
  session.topics = read_topics(root);
  session.base_height = root.get_optional<double>("base_height");
  if (const auto truth = root.get_optional<Eigen::Vector3d>("truth_in_map")) {
    session.T_map_truth = {truth->x(), truth->y(), truth->z()};
  }
  session.seed = root.get("seed", session.seed);
  session.localizers = read_localizers(root, "localizers", rules);
  read_session_events(root, session);
  check_session_orders(root, session);
  check_map3d(root, session);
  document.reject_unknown_keys();
  session.tree = root.copy();
  return session;
}

}  // namespace castaway::testbed
