/// Changes of the world during a run: objects, doors, more people.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/people/bodies/person.hpp"
#include "sim/record/happening.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// An object is put into the world. It is not on the map.
struct PutObject {
  WorldObject object;
};

/// An object that was put there is taken away.
struct TakeObject {
  std::string name;
};

/// A door is opened or closed.
struct TurnDoor {
  std::string name;
  double open_deg = 0.0;  ///< [deg] 0: closed.
};

/// People come: one, or a group that walks together or stands and talks.
struct AddPeople {
  Pose2 T_map_person;  ///< Of the first one, or of the middle of a group that talks.
  int count = 1;       ///< 1 to 6; at most 4 who walk.
  bool walk = false;   ///< From place to place; false: they stand there.
  std::optional<Behaviour> behaviour = Behaviour::kRegular;  ///< Nothing: mixed.
};

/// A change, which takes place as soon as there is room for it: not on the robot or on a person.
struct WorldChange {
  double at_s = 0.0;  ///< [s] Since the start of the run.
  std::variant<PutObject, TakeObject, TurnDoor, AddPeople> what;
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const WorldChange& change);

/// Changes a world. Indices of objects stay as they are. @throws std::invalid_argument if the name
/// of an object is taken, or if there is no such object or door.
void apply(const WorldChange& change, WorldSpec& world);

/// A world after changes, applied in order of time: objects as they are named and numbered at the
/// end of a run. @throws as `apply` and `validate`.
WorldSpec world_after(WorldSpec world, std::vector<WorldChange> changes);

/// The object that a change leaves where robot or people may be; nothing for other changes. The
/// change must be possible in this world.
std::optional<WorldObject> solid_of(const WorldChange& change, const WorldSpec& world);

/// Name of the object or door that a change is about; empty: it is about people.
std::string name_of(const WorldChange& change);

/// What is told of a change, with the outline of what it leaves in the world as it was before.
WorldNews news_of(const WorldChange& change, const WorldSpec& world);

}  // namespace castaway::sim
