/// Reads JSON files of unknown origin.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

/// True if arrays and objects are nested more than 100 deep, since code that walks the tree
/// recurses.
bool nests_too_deep(std::string_view json);

/// Parses a file. Throws std::runtime_error naming it if it cannot be read, is malformed or is
/// nested too deeply.
nlohmann::ordered_json read_json(const std::filesystem::path& path);

/// Calls `read`, which takes fields of the JSON file `path`. Throws std::runtime_error naming the
/// file where a field is missing or of another type than castaway writes.
void read_fields(const std::filesystem::path& path, const std::function<void()>& read);

}  // namespace castaway::testbed
