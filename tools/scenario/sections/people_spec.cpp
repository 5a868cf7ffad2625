#include "tools/scenario/sections/people_spec.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

constexpr double kCrowdPerShare = 60.0;  // Walkers for all beams, where there is no count.
const char* const kMixed = "mixed";

std::optional<sim::Behaviour> read_behaviour(YamlReader& map) {
  std::vector<std::string> names;
  for (const sim::Behaviour behaviour : sim::kBehaviours) {
    names.emplace_back(sim::behaviour_name(behaviour));
  }
  names.emplace_back(kMixed);
  const std::string name = map.choice("behaviour", names.front(), names);
  if (name == kMixed) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), name);
  return sim::kBehaviours[static_cast<std::size_t>(found - names.begin())];
}

/// As many as such a crowd takes; more would block beams as they pass.
int crowd_count(double blocked_share) {
  return static_cast<int>(std::lround(kCrowdPerShare * blocked_share));
}

int read_count(YamlReader& map, const std::string& key, int fallback) {
  const int count = map.get(key, fallback);
  if (count < 0) map.fail("'" + key + "' must not be negative");
  return count;
}

double read_share(YamlReader& map, const std::string& key, double fallback, double most) {
  const double share = map.get(key, fallback);
  if (!(share >= 0.0 && share <= most)) {
    map.fail("'" + key + "' must be in 0.." + std::string(most < 1.0 ? "0.6" : "1"));
  }
  return share;
}

std::vector<int> read_talking(YamlReader& map) {
  std::vector<int> sizes;
  for (const YamlReader& item : map.list("talking")) {
    sizes.push_back(item.as<int>());
    if (sizes.back() < 2 || sizes.back() > 6) item.fail("a group that talks has 2 to 6 people");
  }
  return sizes;
}

/// [x, y] or [x, y, yaw].
std::vector<sim::Pose2> read_placed(YamlReader& map) {
  std::vector<sim::Pose2> poses;
  for (const YamlReader& item : map.list("at")) {
    const auto numbers = item.as<std::vector<double>>();
    if (numbers.size() != 2 && numbers.size() != 3) item.fail("give [x, y] or [x, y, yaw]");
    poses.push_back({numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0.0});
  }
  return poses;
}

}  // namespace

PeopleSpec read_people(YamlReader& root) {
  PeopleSpec people;
  if (!root.has("people")) return people;
  YamlReader map = root.child("people");
  if (map.has("crowd")) {
    YamlReader body = map.child("crowd");
    people.config.blocked_share = body.require<double>("blocked");
    (void)read_share(body, "blocked", 0.0, 0.6);
  }
  people.config.walking = read_count(map, "count", crowd_count(people.config.blocked_share));
  people.config.behaviour = read_behaviour(map);
  people.config.in_groups = read_share(map, "groups", people.config.in_groups, 1.0);
  people.config.standing = read_count(map, "standing", people.config.standing);
  people.config.talking = read_talking(map);
  people.config.placed = read_placed(map);
  people.config.robot_yields = map.get("robot_yields", people.config.robot_yields);
  people.log_every_s = map.get("log_every_s", people.log_every_s);
  if (!(people.log_every_s >= 0.0)) map.fail("'log_every_s' must not be negative");
  if (people.config.count() > sim::kMaxPeople) map.fail("at most 200 people, all kinds together");
  return people;
}

}  // namespace castaway::testbed
