#include "tools/replay/replay_session.hpp"

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
  return {root.get("scan_topics", std::vector<std::string>{}), root.get("odom_topic", ""),
          root.get("truth_topic", "")};
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

}  // namespace

ReplaySession read_session(YamlDocument document, const ForeignRules& rules) {
  if (!document.root().has("localizers")) document.set("localizers=[mh_amcl]");
  YamlReader root = document.root();
  ReplaySession session;
  session.log = root.require<std::string>("log");
  session.map = root.get("map", "");
  session.known_start = root.choice("start", "unknown", {"truth", "unknown"}) == "truth";
  session.part.from_scan = static_cast<std::size_t>(root.get("from_scan", std::uint64_t{0}));
  if (root.has("scans")) session.part.scans = read_count(root, "scans");
  if (session.part.scans == 0U) root.fail("'scans' is 0: play at least one");
  session.scans_used = read_scans_used(root);
  session.topics = read_topics(root);
  session.seed = root.get("seed", session.seed);
  session.localizers = read_localizers(root, "localizers", rules);
  read_session_events(root, session);
  check_session_orders(root, session);
  document.reject_unknown_keys();
  session.tree = root.copy();
  return session;
}

}  // namespace castaway::testbed
