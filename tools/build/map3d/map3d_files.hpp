/// Files of 3-D maps, by the ends of their names.
#pragma once

#include <filesystem>
#include <string>

#include "tools/build/map3d/survey_map3d.hpp"

namespace castaway::testbed {

/// True for `.map3d`, `.bt` and `.ot`, which hold 3-D maps, and `.pcd` and `.ply`, of which one can
/// be made.
bool is_map3d_source(const std::filesystem::path& file);
/// Throws std::invalid_argument naming the option --map3d if it is none of these files.
void require_map3d_source(const std::filesystem::path& file);
/// True for `.pcd` and `.ply`.
bool is_cloud(const std::filesystem::path& file);
/// True for the files that `encode_map3d_file` makes: `.map3d`, `.bt`, `.ot`.
bool is_map3d_target(const std::filesystem::path& file);

/// Reads any of these files. A `.map3d` is read as it is; an OctoMap keeps its own resolution; in
/// all but a `.map3d` the ground is surveyed. Throws std::runtime_error of one line naming the
/// file.
Map3d read_map3d_file(const std::filesystem::path& file, const Map3dOptions& options);

/// The bytes of a file with this name's end. Throws as `encode_octomap` does.
std::string encode_map3d_file(const Map3d& map, const std::filesystem::path& file);

}  // namespace castaway::testbed
