/// Makes output folders, or says why they cannot be used.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "tools/base/files/file_error.hpp"

namespace castaway::testbed {

/// Throws std::runtime_error with one line.
[[noreturn]] inline void refuse_folder(const std::filesystem::path& folder,
                                       const std::string& why) {
  throw std::runtime_error(folder.string() + ": " + why + "; choose another folder with --out");
}

/// Makes a folder and those above it. Throws FileError if the disk is full, else
/// std::runtime_error: another folder would do.
inline void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  const std::string why = "cannot be made (" + error.message() + ")";
  if (error == std::errc::no_space_on_device) throw FileError(folder.string() + ": " + why);
  refuse_folder(folder, why);
}

}  // namespace castaway::testbed
