/// JSON from files of unknown origin.
#pragma once

#include <filesystem>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

/// True if arrays and objects are nested more than 100 deep: whoever walks such a tree recurses.
bool nests_too_deep(std::string_view json);

/// The JSON of a file. Throws std::runtime_error naming it where it cannot be read, is broken or
/// nested too deep.
nlohmann::ordered_json read_json(const std::filesystem::path& path);

}  // namespace castaway::testbed
