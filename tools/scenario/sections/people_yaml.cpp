#include "tools/scenario/sections/people_yaml.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

constexpr double kCrowdPerShare = 60.0;  // Walkers per blocked share of 1, if no count is given.

/// Number of walkers that suffices for the share; more would block additional beams in passing.
int crowd_count(double blocked_share) {
  return static_cast<int>(std::lround(kCrowdPerShare * blocked_share));
}

std::vector<int> read_talking(YamlReader& map) {
  std::vector<int> sizes;
  for (const YamlReader& item : map.list("talking")) {
    sizes.push_back(item.as<int>());
    if (sizes.back() < 2 || sizes.back() > 6) item.fail("a group that talks has 2 to 6 people");
  }
  return sizes;
}

/// Reads poses [x, y] or [x, y, yaw].
std::vector<sim::Pose2> read_placed(YamlReader& map) {
  std::vector<sim::Pose2> poses;
  for (const YamlReader& item : map.list("at")) {
    item.require_in({-1e7, 1e7}, "m, rad");
    const auto numbers = item.as<std::vector<double>>();
    if (numbers.size() != 2 && numbers.size() != 3) item.fail("give [x, y] or [x, y, yaw]");
    poses.push_back({numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0.0});
  }
  return poses;
}

constexpr NumberRange kPeopleCount{0.0, sim::kMaxPeople};

void crowd_fields(Settings settings, sim::PeopleConfig& people) {
  settings.field({"blocked",
                  "",
                  "Share of the lidar's beams that walkers around the robot block.",
                  {0.0, 0.6}},
                 people.blocked_share);
}

}  // namespace

std::vector<std::pair<std::string, std::optional<sim::Behaviour>>> behaviours() {
  std::vector<std::pair<std::string, std::optional<sim::Behaviour>>> names;
  for (const sim::Behaviour behaviour : sim::kBehaviours) {
    names.emplace_back(sim::behaviour_name(behaviour), behaviour);
  }
  names.emplace_back("mixed", std::nullopt);
  return names;
}

void fields(Settings settings, PeopleSpec& people) {
  sim::PeopleConfig& config = people.config;
  settings.field(
      {"count", "",
       "Number of people who walk from place to place; with `blocked`, as many as necessary.",
       kPeopleCount},
      config.walking);
  settings.choice({"behaviour", "", "Their reaction to the robot."}, config.behaviour,
                  behaviours());
  settings.field({"groups", "", "Share of the walkers in groups of 2 to 4.", {0.0, 1.0}},
                 config.in_groups);
  settings.field({"standing", "", "Number of people who stand at random places.", kPeopleCount},
                 config.standing);
  settings.form({"talking", "", "Sizes of groups that stand and talk, 2 to 6 each.", {2.0, 6.0}},
                "[]");
  settings.form({"at", "m, rad", "Standing people by pose: a list of [x, y] or [x, y, yaw]."},
                "[]");
  settings.field({"robot_yields", "", "A robot driven by the truth stops for people."},
                 config.robot_yields);
  settings.field({"log_every_s",
                  "s",
                  "Time between two rows of a person in people.csv; 0: no file.",
                  {0.01, 1e7, true}},
                 people.log_every_s);
  if (settings.describes()) crowd_fields(settings.group("crowd"), config);
}

PeopleSpec read_people(YamlReader& root) {
  PeopleSpec people;
  if (!root.has("people")) return people;
  YamlReader map = root.child("people");
  if (map.has("crowd")) {
    YamlReader crowd = map.child("crowd");
    people.config.blocked_share = crowd.require<double>("blocked");
    crowd_fields(Settings::reading(crowd), people.config);
    people.config.walking = crowd_count(people.config.blocked_share);
  }
  fields(Settings::reading(map), people);
  people.config.talking = read_talking(map);
  people.config.placed = read_placed(map);
  if (people.config.count() > sim::kMaxPeople) map.fail("at most 200 people, all kinds together");
  return people;
}

}  // namespace castaway::testbed
