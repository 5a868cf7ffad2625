#include "sim/difference/difference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/difference/room_check.hpp"
#include "sim/map/free_space.hpp"
#include "sim/world/door.hpp"
#include "sim/world/footprint.hpp"
#include "sim/world/furniture.hpp"

namespace castaway::sim {
namespace {

constexpr int kTries = 60;
constexpr double kOpen = 90.0;  // [deg]
constexpr double kAjar = 10.0;  // [deg] A door open by less counts as closed.
constexpr double kDegree = std::numbers::pi / 180.0;

/// Applies changes to a world and counts them.
class Changer {
 public:
  Changer(WorldSpec world, const DifferenceSpec& spec, const Grid& map) : spec_(spec), map_(map) {
    result_.world = std::move(world);
  }

  ChangedWorld run(const KeepClear& keep, Rng& rng) {
    for (const Change& change : spec_.changes) carry_out(change);
    RoomCheck room(result_.world, map_, keep);
    change_furniture(room, rng);
    change_doors(room, rng);
    add_boxes(room, rng);
    note("pieces of furniture were not moved: there is no room elsewhere", stuck_);
    note("doors were not turned: a route or furniture is in the way", blocked_);
    return std::move(result_);
  }

 private:
  void carry_out(const Change& change);
  void carry_out_on_furniture(const Change& change);
  void change_furniture(RoomCheck& room, Rng& rng);
  bool move_at_random(const FurnitureGroup& group, RoomCheck& room, Rng& rng);
  void change_doors(RoomCheck& room, Rng& rng);
  void add_boxes(RoomCheck& room, Rng& rng);
  bool add_box(const FreeSpace& space, RoomCheck& room, Rng& rng);
  void place(WorldObject object);
  void note(const char* what, const std::vector<std::string>& who);

  const DifferenceSpec& spec_;
  const Grid& map_;
  ChangedWorld result_;
  std::vector<std::string> stuck_;    ///< Furniture that could not be moved.
  std::vector<std::string> blocked_;  ///< Doors that could not be turned.
};

/// Adds a note with the number of names and the first four of them.
void Changer::note(const char* what, const std::vector<std::string>& who) {
  if (who.empty()) return;
  const auto shown = static_cast<std::ptrdiff_t>(std::min<std::size_t>(who.size(), 4));
  result_.notes.push_back(fmt::format("{} {} ({}{})", who.size(), what,
                                      fmt::join(who.begin(), who.begin() + shown, ", "),
                                      who.size() > 4 ? ", ..." : ""));
}

void Changer::carry_out(const Change& change) {
  switch (change.kind) {
    case Change::Kind::kOpen:
      set_door(result_.world, change.name, change.open_deg);
      ++result_.opened;
      return;
    case Change::Kind::kClose:
      set_door(result_.world, change.name, 0.0);
      ++result_.closed;
      return;
    case Change::Kind::kAdd:
      for (const WorldObject& object : change.objects) place(object);
      return;
    default:
      carry_out_on_furniture(change);
  }
}

/// Moves or removes the bodies with the given name, and those of the piece or wall with that name.
void Changer::carry_out_on_furniture(const Change& change) {
  FurnitureGroup group;
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < result_.world.objects.size(); ++i) {
    const WorldObject& object = result_.world.objects[i];
    const bool named = object.name == change.name || object.name.starts_with(change.name + "/");
    if (!named || !object.in_world) continue;
    group.objects.push_back(i);
    box.extend(bounds(footprint(object)));
  }
  if (group.objects.empty()) {
    throw std::invalid_argument(fmt::format("differences: world {} has nothing named '{}'",
                                            result_.world.name, change.name));
  }
  group.center = box.center();
  if (change.kind == Change::Kind::kRemove) {
    remove_group(result_.world, group);
    ++result_.removed;
  } else {
    move_group(result_.world, group, change.turn_deg * kDegree, change.by);
    ++result_.moved;
  }
}

void Changer::place(WorldObject object) {
  object.in_map = false;
  result_.world.objects.push_back(std::move(object));
  ++result_.added;
}

/// Every group takes the same number of draws from `rng`, so that the change of one does not affect
/// the draws of another.
void Changer::change_furniture(RoomCheck& room, Rng& rng) {
  for (const FurnitureGroup& group : furniture_groups(result_.world)) {
    const double fate = draw_between(0.0, 1.0, rng);
    Rng own(rng());
    if (fate < spec_.remove) {
      remove_group(result_.world, group);
      for (const std::size_t i : group.objects) room.update(result_.world, i);
      ++result_.removed;
    } else if (fate < spec_.remove + (1.0 - spec_.remove) * spec_.move_furniture) {
      result_.moved += move_at_random(group, room, own) ? 1 : 0;
    }
  }
}

bool Changer::move_at_random(const FurnitureGroup& group, RoomCheck& room, Rng& rng) {
  for (int attempt = 0; attempt < kTries; ++attempt) {
    // Shrinks with every attempt.
    const double reach = 1.0 - static_cast<double>(attempt) / kTries;
    const double bearing = draw_between(-std::numbers::pi, std::numbers::pi, rng);
    const double way = reach * spec_.reach_m * std::sqrt(draw_between(0.01, 1.0, rng));
    const double yaw = reach * draw_between(-45.0, 45.0, rng) * kDegree;
    const Eigen::Vector2d by = way * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    std::vector<ConvexOutline> outlines;
    for (const ConvexOutline& o : group.footprints) {
      outlines.push_back(transform_outline(o, group.center, yaw, by));
    }
    if (!room.fits(outlines, group.objects)) continue;
    move_group(result_.world, group, yaw, by);
    for (const std::size_t i : group.objects) room.update(result_.world, i);
    return true;
  }
  const WorldObject& first = result_.world.objects[group.objects.front()];
  stuck_.push_back(first.piece.empty() ? first.name : first.piece);
  return false;
}

void Changer::change_doors(RoomCheck& room, Rng& rng) {
  const std::vector<Door> doors = result_.world.doors;
  for (const Door& door : doors) {
    const double fate = draw_between(0.0, 1.0, rng);
    const bool open = std::abs(door.open_deg) > kAjar;
    if (fate >= (open ? spec_.close_doors : spec_.open_doors)) continue;
    const double to = open ? 0.0 : kOpen;
    if (!room.leaf_fits(footprint(door_leaf(door, to)))) {
      blocked_.push_back(door.name);
      continue;
    }
    set_door(result_.world, door.name, to);
    ++(open ? result_.closed : result_.opened);
  }
}

void Changer::add_boxes(RoomCheck& room, Rng& rng) {
  if (spec_.add_boxes == 0) return;
  const FreeSpace space(map_, 0.2);
  int missing = 0;
  for (int i = 0; i < spec_.add_boxes; ++i) missing += add_box(space, room, rng) ? 0 : 1;
  if (missing == 0) return;
  result_.notes.push_back(fmt::format("no room for {} of {} boxes", missing, spec_.add_boxes));
}

bool Changer::add_box(const FreeSpace& space, RoomCheck& room, Rng& rng) {
  const double length = draw_between(0.3, 0.8, rng);
  const double width = draw_between(0.3, 0.8, rng);
  const Eigen::Vector3d size(length, width, draw_between(0.3, 1.2, rng));
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const auto pose = space.sample(rng);
    if (!pose) return false;
    WorldObject box;
    box.name = fmt::format("left-behind-{}", result_.added);
    box.shape = BoxShape{size};
    box.T_map_object = Eigen::Translation3d(0.0, 0.0, 0.5 * size.z()) * to_isometry(*pose);
    box.color = {0.85F, 0.45F, 0.2F};
    box.movable = true;
    if (!room.fits({footprint(box)}, {})) continue;
    place(box);
    room.update(result_.world, result_.world.objects.size() - 1);
    return true;
  }
  return false;
}

}  // namespace

ChangedWorld change_world(WorldSpec world, const DifferenceSpec& spec, const Grid& map,
                          const KeepClear& keep, Rng& rng) {
  validate(spec);
  return Changer(std::move(world), spec, map).run(keep, rng);
}

}  // namespace castaway::sim
