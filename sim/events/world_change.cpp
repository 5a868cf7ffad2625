#include "sim/events/world_change.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "sim/world/door.hpp"
#include "sim/world/footprint.hpp"

namespace castaway::sim {
namespace {

constexpr int kMostTalking = 6;
constexpr int kMostWalking = 4;
constexpr double kWidestDoor = 180.0;  // [deg]

/// Calls the function that is made for the alternative of a variant.
template <typename... F>
struct OneOf : F... {
  using F::operator()...;
};
template <typename... F>
OneOf(F...) -> OneOf<F...>;  // Clang 14 does not find it by itself.

std::vector<WorldObject>::iterator find_object(WorldSpec& world, const std::string& name) {
  return std::ranges::find(world.objects, name, &WorldObject::name);
}

void put(const PutObject& put, WorldSpec& world) {
  if (find_object(world, put.object.name) != world.objects.end()) {
    throw std::invalid_argument(
        fmt::format("object: world {} has an object '{}' already: give "
                    "another name",
                    world.name, put.object.name));
  }
  world.objects.push_back(put.object);
  world.objects.back().in_map = false;
}

/// The object stays in the list, and its name is taken: indices are labels of what beams hit.
void take(const TakeObject& take, WorldSpec& world) {
  const auto object = find_object(world, take.name);
  if (object == world.objects.end() || object->in_map || !object->in_world) {
    throw std::invalid_argument(
        fmt::format("remove: no object '{}' was put into world {}: give "
                    "the name of one that was",
                    take.name, world.name));
  }
  object->in_world = false;
}

const Door& door_of(const WorldSpec& world, const std::string& name) {
  const auto door = std::ranges::find(world.doors, name, &Door::name);
  if (door != world.doors.end()) return *door;
  throw std::invalid_argument(fmt::format("door: world {} has no door '{}'", world.name, name));
}

void check_people(const AddPeople& people) {
  const int most = people.walk ? kMostWalking : kMostTalking;
  if (people.count < 1 || people.count > most) {
    throw std::invalid_argument(fmt::format("people: {} at once: give 1 to {}, or 1 to {} who walk",
                                            people.count, kMostTalking, kMostWalking));
  }
}

}  // namespace

void validate(const WorldChange& change) {
  if (!(change.at_s >= 0.0)) {
    throw std::invalid_argument("world change: at_s must not be negative");
  }
  if (const auto* people = std::get_if<AddPeople>(&change.what)) check_people(*people);
  const auto* door = std::get_if<TurnDoor>(&change.what);
  if (door != nullptr && !(std::abs(door->open_deg) <= kWidestDoor)) {
    throw std::invalid_argument("door: open_deg must be from -180 to 180");
  }
}

void apply(const WorldChange& change, WorldSpec& world) {
  std::visit(OneOf{[&](const PutObject& object) { put(object, world); },
                   [&](const TakeObject& object) { take(object, world); },
                   [&](const TurnDoor& door) { set_door(world, door.name, door.open_deg); },
                   [](const AddPeople&) {}},
             change.what);
}

WorldSpec world_after(WorldSpec world, std::vector<WorldChange> changes) {
  std::ranges::stable_sort(changes, {}, &WorldChange::at_s);
  for (const WorldChange& change : changes) {
    validate(change);
    apply(change, world);
  }
  return world;
}

std::optional<WorldObject> solid_of(const WorldChange& change, const WorldSpec& world) {
  if (const auto* put = std::get_if<PutObject>(&change.what)) return put->object;
  if (const auto* door = std::get_if<TurnDoor>(&change.what)) {
    return door_leaf(door_of(world, door->name), door->open_deg);
  }
  return std::nullopt;
}

std::string name_of(const WorldChange& change) {
  return std::visit(OneOf{[](const PutObject& put) { return put.object.name; },
                          [](const AddPeople&) { return std::string(); },
                          [](const auto& named) { return named.name; }},
                    change.what);
}

WorldNews news_of(const WorldChange& change, const WorldSpec& world) {
  using What = WorldNews::What;
  WorldNews news;
  news.what = std::visit(
      OneOf{[](const PutObject& put) -> What { return WorldNews::Put{put.object.name}; },
            [](const TakeObject& take) -> What { return WorldNews::Take{take.name}; },
            [](const TurnDoor& door) -> What {
              return WorldNews::Door{door.name, door.open_deg};
            },
            [](const AddPeople& people) -> What { return WorldNews::People{people.count}; }},
      change.what);
  if (const auto solid = solid_of(change, world)) {
    news.outline = footprint(*solid).points;
    news.z = {bounds(*solid).min().z(), bounds(*solid).max().z()};
  }
  return news;
}

}  // namespace castaway::sim
