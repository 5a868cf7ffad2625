/// Cuts an SDF world into its models, so that an unreadable one does not affect the others, and
/// thousands are not in memory at the same time.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/common/random.hpp"
#include "sim/world/floor.hpp"
#include "sim/world/sdf/classic_state.hpp"
#include "sim/world/sdf/notes.hpp"
#include "sim/world/sdf/resource_finder.hpp"

namespace castaway::sim {

/// A model or an include.
struct WorldPiece {
  std::string name;  ///< For messages.
  std::string xml;
};

/// The pieces of an SDF file's first world, or its one model.
struct WorldPieces {
  std::string name;                ///< Of the world; empty if the file has only a model.
  std::string version = "1.6";     ///< Of the file's format.
  std::string frames;              ///< Elements that all pieces may refer to.
  std::vector<WorldPiece> pieces;  ///< In the file's order.
  ClassicState state;              ///< Where Gazebo classic puts them.
  std::set<std::string> left_out;  ///< Names of models that are no pieces: ground, sun, unreadable.
  bool linked = false;             ///< Pieces may refer to each other.
  std::optional<Ground> ground;    ///< Of an included ground plane.
  Eigen::Vector2d size = Eigen::Vector2d::Zero();  ///< [m] Lower bound for the world's size.
};

/// Handling of pieces that cannot be read.
struct PiecePolicy {
  bool strict = false;     ///< They are errors instead of notes.
  Notes* notes = nullptr;  ///< Collects what was left out, and why.
};

/// Cuts the text of a world; drops sun, ground, sensors, plug-ins, lights and masses. An include
/// whose files cannot be read is left out. Insertions of the state and the models of populations
/// are pieces, too; `streams` draw the places of those. `path`: of the world, for errors.
/// @throws std::runtime_error, std::length_error naming file and reason.
WorldPieces cut_world(const std::string& path, const std::string& text,
                      const ResourceFinder& finder, const PiecePolicy& policy,
                      const NamedStreams& streams);

/// The text of a world that holds the pieces [begin, end).
std::string sdf_text(const WorldPieces& world, std::size_t begin, std::size_t end);

}  // namespace castaway::sim
