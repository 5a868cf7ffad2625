#include "tools/outputs/records/hit_legend.hpp"

#include <array>

namespace castaway::testbed {

const char* class_name(BeamClass of) {
  constexpr std::array<const char*, kBeamClasses> kNames = {
      "none", "static", "unmapped", "moved", "door", "person", "glass", "floor", "dust", "cover"};
  return kNames[static_cast<std::size_t>(of)];
}

bool hides_map(BeamClass of) {
  switch (of) {
    case BeamClass::kUnmapped:
    case BeamClass::kMoved:
    case BeamClass::kDoor:
    case BeamClass::kPerson:
    case BeamClass::kDust:
    case BeamClass::kCover:
      return true;
    default:
      return false;
  }
}

BeamClass HitLegend::class_of(int label) const {
  if (label >= first_person) return BeamClass::kPerson;
  const auto found = entries.find(label);
  return found == entries.end() ? BeamClass::kNone : found->second.of;
}

int HitLegend::id_of(int label) const {
  if (label >= first_person) return label - first_person;
  return label >= 0 && entries.contains(label) ? label : -1;
}

}  // namespace castaway::testbed
