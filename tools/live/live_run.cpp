#include "tools/live/live_run.hpp"

#include <utility>

#include "castaway/stamp.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/build_robot.hpp"
#include "tools/build/build_sensors.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/map3d/level_maps.hpp"
#include "tools/build/map3d/run_volume.hpp"
#include "tools/build/ros2/bridge_messages.hpp"
#include "tools/build/scan_truth.hpp"
#include "tools/build/scene/visible_scene.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

constexpr double kEndless = 100.0 * 86400.0;  // [s]

YamlNode& child(YamlNode& map, const std::string& key) {
  if (YamlNode* found = map.find(key)) return *found;
  map.entries.push_back({key, {}});
  return map.entries.back().value;
}

}  // namespace

LiveRun::LiveRun(const LoadedScenario& loaded, const std::filesystem::path& base,
                 SharedWorlds& worlds, const LiveSinkMaker& make_sink, TopicWriter* bridge)
    : scenario_(parse_yaml(loaded.effective, "scenario")) {
  Scenario scenario = loaded.scenario;
  scenario.duration_s = kEndless;
  scenario.stop_after_m = 0.0;
  PreparedSimulation prepared = build_simulation(scenario, base, &worlds);
  prepared.config.open = true;
  const RunInfo info{scenario.name,
                     prepared.world_name,
                     prepared.config.robot.name,
                     scenario.seed,
                     scenario.start.initializes(),
                     names_of(scenario.localizers),
                     prepared.difference,
                     prepared.config.levels != nullptr,
                     prepared.notes};
  sinks_.push_back(make_sink(info, prepared.map, prepared.config.robot.footprint_radius));
  if (prepared.config.levels) {
    levels_ = std::make_unique<const LevelMaps>(level_maps(*prepared.config.levels));
  }
  lidars_ = prepared.config.lidars;
  scene_ = {page_world(prepared.config.world), robot_items(prepared.config.robot, lidars_)};
  BridgeConfig told;
  if (bridge != nullptr) tell_robot(scenario.robot, base, prepared.config, told);
  localizers_ = build_localizers(scenario.localizers,
                                 {.map = prepared.map,
                                  .lidars = lidars_of(prepared.config.lidars),
                                  .volume = volume_of(prepared.config, prepared.survey)},
                                 scenario.seed);
  source_ = build_source(scenario, std::move(prepared.config));
  const LoopConfig start_config =
      loop_config(scenario, *source_->start_pose(), source_->start_height());
  loop_ = std::make_unique<Loop>(start_config, localizers_, sinks_);
  loop_->begin();
  if (bridge == nullptr) return;
  told.start = start_config.start;
  sinks_.push_back(std::make_unique<BridgeMessages>(info, prepared.map, told, *bridge));
}

std::string LiveRun::scene() {
  scene_.world = page_world(source_->world());
  scene_.people = source_->people_bodies();
  return page_scene_json(scene_, kLiveSceneBytes);
}

bool LiveRun::step() {
  const bool more = loop_->step(*source_);
  loop_->require_outputs();
  return more;
}

/// The simulator's events take place at its next step, a localizer's after the last delivery.
Stamp LiveRun::time_of(const std::string& event) const {
  const LiveEvent now = read_live_event(event, loop_->now(), 1);
  return now.specs.orders.empty() ? source_->now() : loop_->now();
}

void LiveRun::apply(const EventSpecs& specs) {
  check_faults(specs.simulated.faults, lidars_);
  for (const sim::EventSpec& event : all_of(specs.simulated)) source_->add(event);
  for (const LocalizerOrder& order : specs.orders) loop_->add(order);
}

Stamp LiveRun::add(const std::string& event) {
  const Stamp at = time_of(event);
  YamlNode& events = child(scenario_, "events");
  LiveEvent added = read_live_event(event, at, events.items.size() + 1);
  apply(added.specs);
  events.kind = YamlNode::Kind::kList;
  events.items.push_back(std::move(added.node));
  return at;
}

std::string LiveRun::saved() const {
  YamlNode saved = scenario_;
  child(saved, "duration_s") = write_yaml(localization::seconds(source_->now()));
  return emit_yaml(saved);
}

}  // namespace castaway::testbed
