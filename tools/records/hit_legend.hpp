/// What beams met, in classes for learning.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace castaway::testbed {

/// What a beam met. The numbers stand in files: they never change.
enum class BeamClass : std::uint8_t {
  kNone = 0,      ///< Nothing within range.
  kStatic = 1,    ///< Something that is on the map.
  kUnmapped = 2,  ///< Something that is not on the map...
  kMoved = 3,     ///< ...or elsewhere on it: furniture that was moved...
  kDoor = 4,      ///< ...or a door that stands otherwise.
  kPerson = 5,
  kGlass = 6,
  kFloor = 7,
  kDust = 8,
  kCover = 9,  ///< What blocks the lidar itself.
};

/// How many classes there are.
inline constexpr int kBeamClasses = 10;

/// "static", "person"...
const char* class_name(BeamClass of);

/// True for what stands in the way of what the map shows: people, dust, a cover, and whatever is
/// not on the map or elsewhere on it.
bool hides_map(BeamClass of);

/// What the labels of a run's beams mean (`ScanTruth::labels`).
struct HitLegend {
  /// What a label stands for.
  struct Entry {
    BeamClass of = BeamClass::kStatic;
    std::string name;  ///< Of the object.
  };

  std::map<int, Entry> entries;                        ///< By label; people and nothing have none.
  int first_person = std::numeric_limits<int>::max();  ///< Label of person 0.

  /// The class of a label; nothing for those that have no entry.
  [[nodiscard]] BeamClass class_of(int label) const;
  /// A person's number, an object's label; -1 for all else.
  [[nodiscard]] int id_of(int label) const;
};

}  // namespace castaway::testbed
