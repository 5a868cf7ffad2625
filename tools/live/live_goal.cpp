#include "tools/live/live_goal.hpp"

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using GoalJson = nlohmann::ordered_json;
using localization::Stamp;

}  // namespace

std::string to_line(const LiveGoal& goal) {
  GoalJson events = GoalJson::array();
  for (const HandEvent& done : goal.events) {
    if (done.at <= goal.time) events.push_back({done.step, done.at.count(), done.event});
  }
  return json_text(GoalJson{{"time_ns", goal.time.count()},
                            {"speed", goal.speed},
                            {"playing", goal.playing},
                            {"events", std::move(events)},
                            {"commands", goal.commands}});
}

LiveGoal goal_of(const std::string& line) {
  const GoalJson order = GoalJson::parse(line);
  LiveGoal goal{Stamp(order.at("time_ns").get<std::int64_t>()),
                order.at("speed").get<double>(),
                order.at("playing").get<bool>(),
                {},
                order.at("commands").get<std::vector<std::string>>()};
  for (const GoalJson& done : order.at("events")) {
    goal.events.push_back({done.at(0).get<std::size_t>(), Stamp(done.at(1).get<std::int64_t>()),
                           done.at(2).get<std::string>()});
  }
  return goal;
}

}  // namespace castaway::testbed
