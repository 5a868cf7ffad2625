#include "sim/casting/surfaces.hpp"

namespace castaway::sim {
namespace {

const Surface kPerson{0.4, false};
const Surface kFloor{0.3, false};
const Surface kDust{0.1, false};
const Surface kOther{};

}  // namespace

Surfaces::Surfaces(const WorldSpec& world) {
  for (const WorldObject& object : world.objects) objects_.push_back(object.surface);
}

const Surface& Surfaces::of(int hit) const {
  if (is_person(hit)) return kPerson;
  if (hit == kHitFloor) return kFloor;
  if (hit == kHitDust) return kDust;
  const auto index = static_cast<std::size_t>(hit);
  return hit >= 0 && index < objects_.size() ? objects_[index] : kOther;
}

std::string hit_name(const WorldSpec& world, int hit) {
  if (is_person(hit)) return "person " + std::to_string(hit - kHitPerson);
  if (hit == kHitFloor) return "floor";
  if (hit == kHitDust) return "dust";
  if (hit == kHitCover) return "cover";
  const auto index = static_cast<std::size_t>(hit);
  if (hit < 0 || index >= world.objects.size()) return "nothing";
  const WorldObject& object = world.objects[index];
  if (object.surface.glass) return "glass " + object.name;
  return (object.in_map ? "object " : "unmapped ") + object.name;
}

}  // namespace castaway::sim
