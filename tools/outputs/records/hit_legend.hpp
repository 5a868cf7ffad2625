/// Beam labels: the objects that beams hit, in classes for learning.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace castaway::testbed {

/// Class of the object that a beam hit. The numbers are stored in files and must never change.
enum class BeamClass : std::uint8_t {
  kNone = 0,      ///< Nothing within range.
  kStatic = 1,    ///< Something that is on the map.
  kUnmapped = 2,  ///< Not on the map.
  kMoved = 3,     ///< Furniture that has been moved since mapping.
  kDoor = 4,      ///< A door in another position than on the map.
  kPerson = 5,
  kGlass = 6,
  kFloor = 7,
  kDust = 8,
  kCover = 9,  ///< A cover that blocks the lidar itself.
};

inline constexpr int kBeamClasses = 10;

/// "static", "person"...
const char* class_name(BeamClass of);

/// True for classes that hide mapped structure: people, dust, a cover, and whatever is not on the
/// map or has been moved.
bool hides_map(BeamClass of);

/// Meaning of the labels of a run's beams (`ScanTruth::labels`).
struct HitLegend {
  /// Meaning of one label.
  struct Entry {
    BeamClass of = BeamClass::kStatic;
    std::string name;  ///< Name of the object.
  };

  std::map<int, Entry> entries;                        ///< By label; people and misses have no
                                                       ///< entry.
  int first_person = std::numeric_limits<int>::max();  ///< Label of person 0.

  /// Class of a label, also for misses and people.
  [[nodiscard]] BeamClass class_of(int label) const;
  /// Id of a person, label of an object; -1 for anything else.
  [[nodiscard]] int id_of(int label) const;
};

}  // namespace castaway::testbed
