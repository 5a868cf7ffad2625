/// Serialises a mesh, or the reason why there is none, for transfer between two processes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// Why a mesh could not be read.
struct MeshFailure {
  std::string text;
  bool too_large = false;  ///< The exception was a std::length_error.
};

using MeshAnswer = std::variant<sim::TriangleMesh, MeshFailure>;

std::string to_bytes(const MeshAnswer& answer);
/// Returns nothing if the bytes are incomplete.
std::optional<MeshAnswer> mesh_answer(std::string_view bytes);

}  // namespace castaway::testbed
