#include "tools/live/live_building.hpp"

#include <string>
#include <utility>

#include "tools/live/live_log.hpp"
#include "tools/live/live_run.hpp"
#include "tools/live/served_nodes.hpp"

namespace castaway::testbed {
namespace {

std::unique_ptr<LivePlay> build_live_log(const LiveSetup& setup, const LiveSinkMaker& make_sink) {
  ReplaySession session = *setup.session;
  serve_nodes(session.tree, session.localizers);
  auto log = std::make_unique<LiveLog>(std::move(session), make_sink, setup.bridge.get());
  for (const std::string& warning : log->warnings()) {
    if (setup.warn) setup.warn(warning);
  }
  return log;
}

}  // namespace

std::unique_ptr<LivePlay> build_live(const LiveSetup& setup, SharedWorlds& worlds,
                                     const LiveSinkMaker& make_sink) {
  if (setup.bridge) setup.bridge->restart();
  if (setup.session) return build_live_log(setup, make_sink);
  LoadedScenario scenario = setup.scenario;
  serve_nodes(parse_yaml(scenario.effective, "scenario"), scenario.scenario.localizers);
  return std::make_unique<LiveRun>(scenario, setup.base, worlds, make_sink, setup.bridge.get());
}

}  // namespace castaway::testbed
