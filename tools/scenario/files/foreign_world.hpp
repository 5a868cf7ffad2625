/// Recognises worlds of other simulators.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// What a world file is, by its first bytes, if castaway does not read it: "a world of Webots".
std::optional<std::string> foreign_format(std::string_view head);

/// Refuses a world in a format of another simulator. A file that cannot be read is left to its
/// reader. @throws std::runtime_error naming the file, its format and what is read.
void refuse_foreign_world(const std::filesystem::path& path);

}  // namespace castaway::testbed
