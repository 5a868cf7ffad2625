/// A mesh, or why there is none, as bytes between two processes of this program.
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
  bool too_large = false;  ///< std::length_error
};

using MeshAnswer = std::variant<sim::TriangleMesh, MeshFailure>;

std::string to_bytes(const MeshAnswer& answer);
/// Nothing if the bytes are no whole answer.
std::optional<MeshAnswer> mesh_answer(std::string_view bytes);

}  // namespace castaway::testbed
